// SPDX-License-Identifier: BSD-3-Clause
// Reads a header of text piece by piece. What cannot be read as asked for is a fault, with the
// file, the line, and what was expected and found.
#ifndef ExaBricksFilesTextScanner_h
#define ExaBricksFilesTextScanner_h

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace exabricks
{
/// With words for the user.
struct FileFault : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Runs `read`. Its faults say that the file may be whole, but is of a kind that is not read.
void readKind(const std::function<void()>& read);

/// For words to the user: cut where it is long.
std::string inQuotes(const std::string& text);
/// With as many digits as tell it from its neighbours in these files.
std::string inDigits(double number);

class TextScanner
{
public:
  /// `firstLine`: the number of the text's first line in its file.
  TextScanner(std::string file, std::string text, std::size_t firstLine = 1)
    : File(std::move(file))
    , Text(std::move(text))
    , FirstLine(firstLine)
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
  /// Whether there are only blanks up to the end.
  bool isAtEnd();
  /// Up to the end of the line, there may be only blanks.
  void endLine();
  /// The rest of the line, whatever it is.
  void skipLine();

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const;
  std::size_t size() const { return this->Text.size(); }

private:
  void SkipBlanks();
  std::string Token() const;

  std::string File;
  std::string Text;
  std::size_t FirstLine;
  std::size_t At = 0;
};
}

#endif
