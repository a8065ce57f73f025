// SPDX-License-Identifier: BSD-3-Clause

#include "Output.h"

#include "Destination.h"
#include "Messages.h"
#include "ParseValues.h"

#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkTIFFWriter.h"
#include "vtkUnsignedCharArray.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#ifdef _WIN32
#include <process.h>
#define getpid _getpid
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace render
{

namespace
{

namespace fs = std::filesystem;

// Gives one file the owner and the permissions of another, if there is that one. Somebody else's
// owner stays what it is where this user may not set it.
void takeOwnerAndPermissions(const std::string& from, const std::string& to)
{
#ifdef _WIN32
  (void)from;
  (void)to;
#else
  struct stat status;
  if (stat(from.c_str(), &status) == 0)
  {
    const bool owned = chown(to.c_str(), status.st_uid, status.st_gid) == 0;
    (void)owned;
    std::error_code ignored;
    fs::permissions(to, static_cast<fs::perms>(status.st_mode & 0777), ignored);
  }
#endif
}

// To the name of the file that it replaces.
void rename(const std::string& path, const std::string& temporary, const std::string& target)
{
  std::error_code error, ignored;
  fs::rename(temporary, target, error);
  if (error)
  {
    fs::remove(temporary, ignored);
    refuseOutput(path, error.message() + ".");
  }
}

void replaceFile(
  const std::string& path, const std::string& target, const char* bytes, std::size_t size)
{
  const std::string temporary = temporaryBeside(target);
  std::error_code ignored;
  errno = 0;
  {
    std::ofstream file(temporary, std::ios::binary);
    if (file)
    {
      takeOwnerAndPermissions(target, temporary);
      errno = 0;
    }
    file.write(bytes, static_cast<std::streamsize>(size));
    file.close();
    if (!file)
    {
      const std::string why = errno ? std::strerror(errno) : "the disk may be full";
      fs::remove(temporary, ignored);
      refuseOutput(path, why + ".");
    }
  }
  rename(path, temporary, target);
}

#ifdef _WIN32
std::FILE* openAsItIs(const Destination& destination)
{
  return std::fopen(destination.Target.c_str(), "wb");
}
#else
// A descriptor is written to at the place where it stands. Nothing is made if the path has gone.
std::FILE* openAsItIs(const Destination& destination)
{
  const int descriptor = destination.Descriptor < 0
    ? open(destination.Target.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)
    : dup(destination.Descriptor);
  return descriptor < 0 ? nullptr : fdopen(descriptor, "wb");
}
#endif

void writeAsItIs(
  const std::string& path, const Destination& destination, const char* bytes, std::size_t size)
{
#ifndef _WIN32
  // A reader that has gone is an error like others, not the end of the program.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
#endif
  errno = 0;
  std::FILE* file = openAsItIs(destination);
  bool fine = file && std::fwrite(bytes, 1, size, file) == size && std::fflush(file) == 0;
  std::string why = errno ? std::strerror(errno) : "it took less than all bytes";
  if (file && std::fclose(file) != 0 && fine)
  {
    fine = false;
    why = std::strerror(errno);
  }
#ifndef _WIN32
  std::signal(SIGPIPE, before);
#endif
  if (!fine)
  {
    refuseOutput(path, why + ".");
  }
}

void writeWhole(const std::string& path, const char* bytes, std::size_t size)
{
  const Destination destination = findDestination(path);
  if (destination.Replace)
  {
    replaceFile(path, destination.Target, bytes, size);
  }
  else
  {
    writeAsItIs(path, destination, bytes, size);
  }
}

// VTK's writer takes files alone: by way of one of its own.
void writeFloats(const std::string& path, vtkImageData* image)
{
  const Destination destination = findDestination(path);
  std::error_code ignored;
  const fs::path own = destination.Replace ? fs::path(destination.Target)
                                           : fs::temp_directory_path(ignored) / "picture.tif";
  const std::string temporary = temporaryBeside(own.string());
  std::string bytes;
  {
    vtkNew<vtkTIFFWriter> writer;
    writer->SetInputData(image);
    writer->SetCompressionToNoCompression(); // the others spoil floats
    writer->SetFileName(temporary.c_str());
    writer->Write();
    std::ifstream file(temporary, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
    fs::remove(temporary, ignored);
  }
  throwIfErrors(ExitCode::OutputUnwritable, "'" + path + "' cannot be written");
  if (bytes.empty())
  {
    refuseOutput(path, "it could not be written to '" + temporary + "' first.");
  }
  writeWhole(path, bytes.data(), bytes.size());
}

}

std::string temporaryBeside(const std::string& path)
{
  const fs::path target(path);
  const std::string name =
    "." + target.filename().string() + ".part" + std::to_string(static_cast<long>(getpid()));
  return (target.parent_path() / name).string();
}

void replaceBy(const std::string& path, const std::string& finished)
{
  const Destination destination = findDestination(path);
  takeOwnerAndPermissions(destination.Target, finished);
  rename(path, finished, destination.Target);
}

void checkWritable(const std::string& path)
{
  const Destination destination = findDestination(path);
  std::error_code error;
  if (!destination.Replace)
  {
    if (!mayBeWritten(destination))
    {
      refuseOutput(
        path, std::string(std::strerror(errno)) + ". Give the name of a file that you may write.");
    }
    return;
  }
  const fs::path folder = fs::absolute(destination.Target).parent_path();
  if (!fs::is_directory(folder, error))
  {
    refuseOutput(path, "there is no folder '" + folder.string() + "'. Make it first.");
  }
  const std::string temporary = temporaryBeside(destination.Target);
  errno = 0;
  const bool opened = static_cast<bool>(std::ofstream(temporary));
  const int reason = errno;
  fs::remove(temporary, error);
  if (!opened)
  {
    refuseOutput(
      path, std::string(std::strerror(reason)) + ". Choose a folder that you may write in.");
  }
}

void writeText(const std::string& path, const std::string& text)
{
  writeWhole(path, text.data(), text.size());
}

std::string pictureEnding(const std::string& path)
{
  const std::string ending = lowerCase(fs::path(path).extension().string());
  return ending == ".jpeg" ? ".jpg" : ending == ".tiff" ? ".tif" : ending;
}

bool holdsFloats(const std::string& path) { return pictureEnding(path) == ".tif"; }

void writePicture(const std::string& path, vtkImageData* image)
{
  if (holdsFloats(path))
  {
    writeFloats(path, image);
    return;
  }
  const auto write = [&](auto* writer)
  {
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    throwIfErrors(ExitCode::OutputUnwritable, "'" + path + "' cannot be written");
    vtkUnsignedCharArray* bytes = writer->GetResult();
    writeWhole(path, reinterpret_cast<const char*>(bytes->GetPointer(0)),
      static_cast<std::size_t>(bytes->GetNumberOfValues()));
  };
  if (pictureEnding(path) == ".jpg")
  {
    vtkNew<vtkJPEGWriter> writer;
    writer->SetQuality(95);
    write(writer.Get());
  }
  else
  {
    vtkNew<vtkPNGWriter> writer;
    write(writer.Get());
  }
}

}
