// SPDX-License-Identifier: BSD-3-Clause

#include "Output.h"

#include "Messages.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#ifdef _WIN32
#include <process.h>
#define getpid _getpid
#else
#include <unistd.h>
#endif

namespace render
{

namespace
{

namespace fs = std::filesystem;

[[noreturn]] void Refuse(const std::string& path, const std::string& why)
{
  throw Failure(ExitCode::OutputUnwritable, "'" + path + "' cannot be written: " + why);
}

std::string TemporaryBeside(const std::string& path)
{
  const fs::path target(path);
  const std::string name =
    "." + target.filename().string() + ".part" + std::to_string(static_cast<long>(getpid()));
  return (target.parent_path() / name).string();
}

void WriteWhole(const std::string& path, const char* bytes, std::size_t size)
{
  const std::string temporary = TemporaryBeside(path);
  std::error_code error, ignored;
  errno = 0;
  {
    std::ofstream file(temporary, std::ios::binary);
    file.write(bytes, static_cast<std::streamsize>(size));
    file.close();
    if (!file)
    {
      const std::string why = errno ? std::strerror(errno) : "the disk may be full";
      fs::remove(temporary, ignored);
      Refuse(path, why + ".");
    }
  }
  fs::rename(temporary, path, error);
  if (error)
  {
    fs::remove(temporary, ignored);
    Refuse(path, error.message() + ".");
  }
}

}

void CheckWritable(const std::string& path)
{
  std::error_code error;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, error))
  {
    Refuse(path, "there is no folder '" + folder.string() + "'. Make it first.");
  }
  if (fs::is_directory(path, error))
  {
    Refuse(path, "it is a folder. Give the name of a file.");
  }
  const std::string temporary = TemporaryBeside(path);
  errno = 0;
  const bool opened = static_cast<bool>(std::ofstream(temporary));
  const int reason = errno;
  fs::remove(temporary, error);
  if (!opened)
  {
    Refuse(path, std::string(std::strerror(reason)) + ". Choose a folder that you may write in.");
  }
}

void WriteText(const std::string& path, const std::string& text)
{
  WriteWhole(path, text.data(), text.size());
}

void WritePNG(const std::string& path, vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  ThrowIfErrors(ExitCode::OutputUnwritable, "'" + path + "' cannot be written");
  vtkUnsignedCharArray* bytes = writer->GetResult();
  WriteWhole(path, reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

}
