// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <iostream>
#include <vector>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace render
{

namespace
{

bool errorStreamIsTerminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}

class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);

  void DisplayErrorText(const char* message) override
  {
    const std::string text = textOf(message);
    // The pipeline says again, in its own words, that a filter failed; the filter's words are the
    // ones to keep.
    const bool echo = text.find("returned failure for request") != std::string::npos;
    if (!(echo && !this->Errors.empty()))
    {
      this->Errors.push_back(echo ? "A step of the pipeline failed and did not say why." : text);
    }
  }

  void DisplayWarningText(const char* message) override
  {
    if (!this->Quiet)
    {
      std::cerr << "Warning: " << textOf(message) << '\n';
    }
  }
  void DisplayGenericWarningText(const char* message) override
  {
    this->DisplayWarningText(message);
  }
  void DisplayText(const char* message) override { std::cerr << message; }

  std::vector<std::string> Errors;
  bool Quiet = false;
};

vtkStandardNewMacro(MessageWindow);

MessageWindow* messageWindow()
{
  return MessageWindow::SafeDownCast(vtkOutputWindow::GetInstance());
}

}

std::string textOf(const char* message)
{
  std::string text = message ? message : "";
  const std::size_t place = text.find(", line ");
  const std::size_t line = place == std::string::npos ? place : text.find('\n', place);
  if (line != std::string::npos)
  {
    text.erase(0, line + 1);
    const std::size_t object = text.find("): ");
    if (text.compare(0, 3, "vtk") == 0 && object != std::string::npos)
    {
      text.erase(0, object + 3);
    }
  }
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  text.erase(end == std::string::npos ? 0 : end + 1);
  return text;
}

void takeMessages(bool quiet)
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageWindow> window;
  window->Quiet = quiet;
  vtkOutputWindow::SetInstance(window);
}

void throwIfErrors(ExitCode code, const std::string& doing)
{
  std::vector<std::string> errors;
  if (MessageWindow* window = messageWindow())
  {
    errors.swap(window->Errors);
  }
  if (errors.empty())
  {
    return;
  }
  const std::size_t shown = 5;
  std::string text = doing + ".";
  for (std::size_t i = 0; i < errors.size() && i < shown; ++i)
  {
    text += "\n  " + errors[i];
  }
  if (errors.size() > shown)
  {
    text += "\n  and " + std::to_string(errors.size() - shown) + " errors more";
  }
  throw Failure(code, text);
}

Progress::Progress(const std::string& what, bool quiet)
  : What(what)
  , Quiet(quiet)
  , Terminal(errorStreamIsTerminal())
{
  if (!this->Quiet)
  {
    std::cerr << this->What << (this->Terminal ? " ..." : "\n") << std::flush;
  }
}

Progress::~Progress()
{
  if (this->Followed)
  {
    this->Followed->RemoveObserver(this->Observer);
  }
  if (!this->Quiet && this->Terminal)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void Progress::Follow(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
    { static_cast<Progress*>(self)->Show(vtkAlgorithm::SafeDownCast(caller)->GetProgress()); });
  this->Observer = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  this->Followed = algorithm;
}

void Progress::Show(double fraction)
{
  const int percent = static_cast<int>(100.0 * fraction);
  if (this->Quiet || !this->Terminal || percent == this->Percent)
  {
    return;
  }
  this->Percent = percent;
  std::cerr << "\r\033[K" << this->What << " ... " << percent << " %" << std::flush;
}

}
