// SPDX-License-Identifier: BSD-3-Clause

#include "Destination.h"

#include "Failure.h"

#include <cerrno>
#include <filesystem>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

namespace render
{

namespace
{

namespace fs = std::filesystem;

// The number that a file in /dev/fd stands for, or -1.
int descriptorOf(const fs::path& file)
{
  std::error_code error;
  const fs::path folder = fs::canonical(file.parent_path(), error);
  const std::string name = file.filename().string();
  if (error || folder != fs::canonical("/dev/fd", error) || error || name.empty() ||
    name.size() > 6 || name.find_first_not_of("0123456789") != std::string::npos)
  {
    return -1;
  }
  return std::stoi(name);
}

}

void refuseOutput(const std::string& path, const std::string& why)
{
  throw Failure(ExitCode::OutputUnwritable, "'" + path + "' cannot be written: " + why);
}

Destination findDestination(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  fs::path target(path);
  for (int links = 0;; ++links)
  {
    const int descriptor = descriptorOf(target);
    if (descriptor >= 0)
    {
      return { target.string(), descriptor, false };
    }
    std::error_code ignored;
    if (!fs::is_symlink(target, ignored))
    {
      break;
    }
    if (!fs::status_known(status) && error != std::errc::too_many_symbolic_link_levels)
    {
      // The system may not let this user follow it.
      refuseOutput(path, "its symbolic link cannot be followed: " + error.message() + ".");
    }
    if (!fs::status_known(status) || links == 40)
    {
      refuseOutput(path,
        "its symbolic links lead in a circle, or through too many others. Mend the link '" +
          target.string() + "', or give another name.");
    }
    const fs::path next = fs::read_symlink(target, ignored);
    target = target.parent_path() / next; // which is `next` if that is absolute
  }
  if (fs::is_directory(status))
  {
    refuseOutput(path, "it is a folder. Give the name of a file.");
  }
  if (fs::is_socket(status))
  {
    refuseOutput(path, "it is a socket. Give the name of a file, a FIFO or a device.");
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    return { path, -1, false };
  }
  return { target.string(), -1, true };
}

#ifdef _WIN32
bool mayBeWritten(const Destination&) { return true; }
#else
bool mayBeWritten(const Destination& destination)
{
  if (destination.Descriptor < 0)
  {
    return access(destination.Target.c_str(), W_OK) == 0;
  }
  const int flags = fcntl(destination.Descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY)
  {
    errno = EBADF;
  }
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}
#endif

}
