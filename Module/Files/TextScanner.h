// SPDX-License-Identifier: BSD-3-Clause
// Reads a header of text piece by piece. What cannot be read as asked for is a fault, with the
// file, the line, and what was expected and found.
#ifndef ExaBricksFilesTextScanner_h
#define ExaBricksFilesTextScanner_h

#include <cstdint>
#include <stdexcept>
#include <string>

namespace exabricks
{
/// With words for the user.
struct FileFault : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class TextScanner
{
public:
  TextScanner(std::string file, std::string text)
    : File(std::move(file))
    , Text(std::move(text))
  {
  }

  /// A whole number from `least` to `most`. All that is read throws a FileFault where it is not so.
  std::int64_t integer(const std::string& what, std::int64_t least, std::int64_t most);
  /// A finite number.
  double number(const std::string& what);
  /// Up to the next blank or the end of the line; not empty.
  std::string word(const std::string& what);
  /// The rest of the line, without blanks around it; not empty.
  std::string line(const std::string& what);
  /// A character, after any blanks.
  void expect(char character);
  /// Whether that character is the next one.
  bool isNext(char character);

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const;
  std::size_t size() const { return this->Text.size(); }

private:
  void SkipBlanks();
  std::string Token() const;

  std::string File;
  std::string Text;
  std::size_t At = 0;
};
}

#endif
