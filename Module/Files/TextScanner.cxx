// SPDX-License-Identifier: BSD-3-Clause
#include "Files/TextScanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <sstream>

namespace exabricks
{
void readKind(const std::function<void()>& read)
{
  try
  {
    read();
  }
  catch (const FileFault& fault)
  {
    throw FileFault("of a kind that is not read: " + std::string(fault.what()));
  }
}

std::string inQuotes(const std::string& text)
{
  std::string shown;
  for (const char c : text.substr(0, 60))
  {
    shown += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  }
  return "'" + shown + "'";
}

std::string inDigits(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  text << number;
  return text.str();
}

void TextScanner::SkipBlanks()
{
  while (
    this->At < this->Text.size() && std::isspace(static_cast<unsigned char>(this->Text[this->At])))
  {
    ++this->At;
  }
}

// What is next, to show: cut, and without what does not print.
std::string TextScanner::Token() const
{
  std::string token;
  for (std::size_t i = this->At; i < this->Text.size() && token.size() < 40; ++i)
  {
    const auto c = static_cast<unsigned char>(this->Text[i]);
    if (std::isspace(c))
    {
      break;
    }
    token += std::isprint(c) ? this->Text[i] : '?';
  }
  return token.empty() ? "the end of the file" : "'" + token + "'";
}

void TextScanner::fail(const std::string& expected, const std::string& found) const
{
  const auto end =
    this->Text.begin() + static_cast<std::ptrdiff_t>(std::min(this->At, this->Text.size()));
  throw FileFault("expected " + expected + " in line " +
    std::to_string(
      this->FirstLine + static_cast<std::size_t>(std::count(this->Text.begin(), end, '\n'))) +
    " of " + this->File + ", found " + found);
}

std::int64_t TextScanner::integer(const std::string& what, std::int64_t least, std::int64_t most)
{
  this->SkipBlanks();
  const char* const begin = this->Text.data() + this->At;
  const char* const end = this->Text.data() + this->Text.size();
  std::int64_t value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || value < least || value > most ||
    (rest != end && (std::isalpha(static_cast<unsigned char>(*rest)) || *rest == '.')))
  {
    this->fail(what + (least == most ? ", " : " from " + std::to_string(least) + " to ") +
        std::to_string(most),
      this->Token());
  }
  this->At += static_cast<std::size_t>(rest - begin);
  return value;
}

double TextScanner::number(const std::string& what)
{
  this->SkipBlanks();
  const char* const begin = this->Text.c_str() + this->At;
  char* rest = nullptr;
  const double value = std::strtod(begin, &rest);
  if (rest == begin || !std::isfinite(value) ||
    (*rest != '\0' && !std::isspace(static_cast<unsigned char>(*rest))))
  {
    this->fail(what + ", a finite number", this->Token());
  }
  this->At += static_cast<std::size_t>(rest - begin);
  return value;
}

std::string TextScanner::word(const std::string& what)
{
  this->SkipBlanks();
  std::size_t end = this->At;
  while (end < this->Text.size() && !std::isspace(static_cast<unsigned char>(this->Text[end])))
  {
    ++end;
  }
  if (end == this->At)
  {
    this->fail(what, this->Token());
  }
  const std::string word = this->Text.substr(this->At, end - this->At);
  this->At = end;
  return word;
}

std::string TextScanner::line(const std::string& what)
{
  this->SkipBlanks();
  const std::size_t end = std::min(this->Text.find('\n', this->At), this->Text.size());
  std::string line = this->Text.substr(this->At, end - this->At);
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
  {
    line.pop_back();
  }
  if (line.empty())
  {
    this->fail(what, this->Token());
  }
  this->At = end;
  return line;
}

void TextScanner::expect(char character)
{
  if (!this->isNext(character))
  {
    this->fail(std::string("'") + character + "'", this->Token());
  }
  ++this->At;
}

bool TextScanner::isNext(char character)
{
  this->SkipBlanks();
  return this->At < this->Text.size() && this->Text[this->At] == character;
}

bool TextScanner::isAtEnd()
{
  this->SkipBlanks();
  return this->At >= this->Text.size();
}

void TextScanner::endLine()
{
  while (this->At < this->Text.size() && this->Text[this->At] != '\n')
  {
    if (!std::isspace(static_cast<unsigned char>(this->Text[this->At])))
    {
      this->fail("the end of the line", this->Token());
    }
    ++this->At;
  }
}

void TextScanner::skipLine()
{
  this->At = std::min(this->Text.find('\n', this->At), this->Text.size());
}
}
