// SPDX-License-Identifier: BSD-3-Clause

#include "Video.h"

#include "Destination.h"
#include "Failure.h"
#include "Output.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

#ifndef _WIN32
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
extern char** environ;
#endif

namespace render
{

namespace
{

// Of each ending ffmpeg's name of the container.
const std::map<std::string, std::string> Containers{ { ".mp4", "mp4" }, { ".mkv", "matroska" },
  { ".webm", "webm" } };

#ifndef _WIN32
bool isInPath(const std::string& program)
{
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(folder) / program;
    if (std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0)
    {
      return true;
    }
  }
  return false;
}
#endif

}

bool Video::IsOne(const std::string& path) { return Containers.count(pictureEnding(path)) > 0; }

void Video::Check(const std::string& path)
{
  if (!findDestination(path).Replace)
  {
    refuseOutput(
      path, "a video takes a file of its own, as ffmpeg goes back in it. Give another name.");
  }
#ifdef _WIN32
  const bool there = false;
#else
  const bool there = isInPath("ffmpeg");
#endif
  if (!there)
  {
    throw Failure(ExitCode::OutputUnwritable,
      "The program ffmpeg makes videos, and is not in the PATH. Install it (Debian: apt-get "
      "install ffmpeg), or give an output that ends in .png, for numbered pictures.");
  }
}

Video::Video(const std::string& path, double framesPerSecond)
  : Path(path)
  , Part(std::filesystem::absolute(temporaryBeside(findDestination(path).Target)).string())
  , Rate(framesPerSecond)
{
}

Video::~Video()
{
  this->Close();
  std::error_code ignored;
  std::filesystem::remove(this->Part, ignored);
}

#ifdef _WIN32

void Video::Start(int, int) { Check(this->Path); }
int Video::Close() { return 1; }

#else

void Video::Start(int width, int height)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    refuseOutput(this->Path, std::strerror(errno));
  }
  fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  std::ostringstream rate;
  rate << this->Rate;
  // Rows come from the bottom up. Players want even sizes, and colours at half of the resolution.
  std::vector<std::string> words{ "ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pixel_format",
    "rgb24", "-video_size", std::to_string(width) + "x" + std::to_string(height), "-framerate",
    rate.str(), "-i", "pipe:0", "-vf", "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p",
    "-f", Containers.at(pictureEnding(this->Path)), this->Part };
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(&word[0]);
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  if (ends[0] != STDIN_FILENO)
  {
    posix_spawn_file_actions_addclose(&actions, ends[0]);
  }
  pid_t process = 0;
  const int error = posix_spawnp(&process, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  if (error != 0)
  {
    close(ends[1]);
    refuseOutput(this->Path, std::string("ffmpeg did not start: ") + std::strerror(error) + ".");
  }
  this->Process = process;
  this->Pipe = fdopen(ends[1], "wb");
  if (!this->Pipe)
  {
    close(ends[1]);
    refuseOutput(this->Path, std::strerror(errno));
  }
}

int Video::Close()
{
  if (this->Pipe)
  {
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    std::fclose(this->Pipe);
    std::signal(SIGPIPE, before);
    this->Pipe = nullptr;
  }
  int status = 1;
  if (this->Process > 0)
  {
    pid_t ended = 0;
    while ((ended = waitpid(this->Process, &status, 0)) < 0 && errno == EINTR)
    {
    }
    status = ended < 0 ? 1 : status; // nobody can tell how it ended
    this->Process = 0;
  }
  return status;
}

#endif

void Video::Add(vtkImageData* picture)
{
  const int* const size = picture->GetDimensions();
  if (!this->Pipe)
  {
    this->Start(size[0], size[1]);
  }
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const auto count = static_cast<std::size_t>(bytes->GetNumberOfValues());
#ifndef _WIN32
  const auto before = std::signal(SIGPIPE, SIG_IGN); // a program that has ended is an error
#endif
  const bool fine = std::fwrite(bytes->GetPointer(0), 1, count, this->Pipe) == count;
#ifndef _WIN32
  std::signal(SIGPIPE, before);
#endif
  if (!fine)
  {
    refuseOutput(this->Path, "ffmpeg ended before it had all pictures; it says why above.");
  }
}

void Video::Finish()
{
  if (this->Close() != 0 || !std::filesystem::exists(this->Part))
  {
    refuseOutput(this->Path, "ffmpeg did not make the video; it says why above.");
  }
  replaceBy(this->Path, this->Part);
}

}
