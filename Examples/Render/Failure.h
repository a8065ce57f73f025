// SPDX-License-Identifier: BSD-3-Clause
// What the program ends with: exit codes, and the exception that carries one up to main() with its
// message.

#ifndef ExaBricksRenderFailure_h
#define ExaBricksRenderFailure_h

#include <stdexcept>
#include <string>

namespace render
{

enum class ExitCode
{
  Fine = 0,
  RenderingFailed = 1,
  BadArguments = 2,
  InputUnreadable = 3,
  OutputUnwritable = 4
};

class Failure : public std::runtime_error
{
public:
  Failure(ExitCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  const ExitCode Code;
};

}

#endif
