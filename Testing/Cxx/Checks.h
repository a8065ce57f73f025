// SPDX-License-Identifier: BSD-3-Clause
// Numeric checks beside a picture, and what VTK's objects have said meanwhile.
#ifndef ExaBricksTestingChecks_h
#define ExaBricksTestingChecks_h

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace test
{
/// Counts what is not as expected, and says so.
class Checks
{
public:
  void Expect(bool holds, const std::string& what)
  {
    if (!holds)
    {
      ++this->Failed;
      std::cerr << "FAILED: " << what << "\n";
    }
  }

  /// Nothing was said. `said`: the messages, taken by the caller. Of two arguments of one call, one
  /// that asks whether there are any and one that takes them, compilers may find either first.
  void Silent(const std::string& said, const std::string& what)
  {
    this->Expect(said.empty(), what + ": " + said);
  }

  void Near(double found, double expected, double tolerance, const std::string& what)
  {
    this->Expect(std::abs(found - expected) <= tolerance,
      what + ": expected " + std::to_string(expected) + " +- " + std::to_string(tolerance) +
        ", found " + std::to_string(found));
  }

  void Equal(double found, double expected, const std::string& what)
  {
    this->Near(found, expected, 0.0, what);
  }

  /// `found` contains each of `words`.
  void Says(
    const std::string& found, const std::vector<std::string>& words, const std::string& what)
  {
    for (const std::string& word : words)
    {
      this->Expect(found.find(word) != std::string::npos,
        what + ": expected '" + word + "' in the message, found '" + found + "'");
    }
  }

  int Status() const { return this->Failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failed = 0;
};

/// Takes VTK's errors and warnings, of all objects, from the screen as long as it lives.
class Messages
{
public:
  Messages()
  {
    this->Previous = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(this->Window);
    this->Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }

  ~Messages()
  {
    vtkOutputWindow::SetInstance(this->Previous);
    vtkLogger::SetStderrVerbosity(this->Verbosity);
  }

  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  const std::vector<std::string>& Errors() const { return this->Window->Errors; }
  const std::vector<std::string>& Warnings() const { return this->Window->Warnings; }

  /// All errors said since the last call, in one string.
  std::string TakeErrors() { return Take(this->Window->Errors); }
  std::string TakeWarnings() { return Take(this->Window->Warnings); }

private:
  static std::string Take(std::vector<std::string>& messages)
  {
    std::string all;
    for (const std::string& message : messages)
    {
      all += message;
    }
    messages.clear();
    return all;
  }

  class Collector : public vtkOutputWindow
  {
  public:
    static Collector* New();
    vtkTypeMacro(Collector, vtkOutputWindow);
    void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
    void DisplayWarningText(const char* text) override { this->Warnings.emplace_back(text); }
    void DisplayGenericWarningText(const char* text) override { this->Warnings.emplace_back(text); }

    std::vector<std::string> Errors;
    std::vector<std::string> Warnings;
  };

  vtkNew<Collector> Window;
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkLogger::Verbosity Verbosity;
};
inline vtkStandardNewMacro(Messages::Collector);
}

#endif
