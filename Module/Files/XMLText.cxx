// SPDX-License-Identifier: BSD-3-Clause
#include "Files/XMLText.h"

#include "Files/TextScanner.h"

#include <algorithm>
#include <cctype>

namespace exabricks
{
namespace
{
constexpr std::size_t MostLevels = 32; // of elements in each other: VTK's have 6
constexpr std::size_t LongestName = 256;

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool isNameCharacter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':' || c == '-' ||
    c == '.';
}

class Reader
{
public:
  Reader(const std::string& file, const std::string& text)
    : File(file)
    , Text(text)
  {
  }

  XMLElement read()
  {
    this->SkipToTag();
    XMLElement root;
    this->ReadElement(root, 1);
    if (!this->IsAppended)
    {
      this->SkipBlanksAndComments();
      if (this->At < this->Text.size())
      {
        this->Fail("the end of the file");
      }
    }
    return root;
  }

private:
  [[noreturn]] void Fail(const std::string& expected) const
  {
    std::string found;
    for (std::size_t i = this->At; i < this->Text.size() && found.size() < 40; ++i)
    {
      const auto c = static_cast<unsigned char>(this->Text[i]);
      if (c == '\n')
      {
        break;
      }
      found += std::isprint(c) ? this->Text[i] : '?';
    }
    throw FileFault("expected " + expected + " in line " + std::to_string(this->LineNumber()) +
      " of " + this->File + ", found " +
      (this->At >= this->Text.size() ? "the end of the file" : "'" + found + "'"));
  }

  // Lines are counted on from where they were counted to.
  std::size_t LineNumber() const
  {
    const auto begin = this->Text.begin();
    const std::size_t end = std::min(this->At, this->Text.size());
    if (this->CountedTo < end)
    {
      this->Line +=
        static_cast<std::size_t>(std::count(begin + static_cast<std::ptrdiff_t>(this->CountedTo),
          begin + static_cast<std::ptrdiff_t>(end), '\n'));
      this->CountedTo = end;
    }
    return this->Line;
  }

  bool IsNext(const char* text) const
  {
    return this->Text.compare(this->At, std::char_traits<char>::length(text), text) == 0;
  }

  void Expect(const char* text)
  {
    if (!this->IsNext(text))
    {
      this->Fail(std::string("'") + text + "'");
    }
    this->At += std::char_traits<char>::length(text);
  }

  void SkipBlanks()
  {
    while (this->At < this->Text.size() && isBlank(this->Text[this->At]))
    {
      ++this->At;
    }
  }

  bool SkipBracketed(const char* begin, const char* end)
  {
    if (!this->IsNext(begin))
    {
      return false;
    }
    const std::size_t place =
      this->Text.find(end, this->At + std::char_traits<char>::length(begin));
    if (place == std::string::npos)
    {
      this->Fail(std::string("'") + end + "' after this");
    }
    this->At = place + std::char_traits<char>::length(end);
    return true;
  }

  void SkipBlanksAndComments()
  {
    do
    {
      this->SkipBlanks();
    } while (this->SkipBracketed("<!--", "-->") || this->SkipBracketed("<?", "?>"));
  }

  // Before the first element.
  void SkipToTag()
  {
    if (this->IsNext("\xEF\xBB\xBF"))
    {
      this->At += 3; // the byte order mark
    }
    this->SkipBlanksAndComments();
    if (this->At + 1 >= this->Text.size() || this->Text[this->At] != '<' ||
      !isNameCharacter(this->Text[this->At + 1]))
    {
      this->Fail("an XML element");
    }
  }

  std::string ReadName()
  {
    const std::size_t begin = this->At;
    while (this->At < this->Text.size() && isNameCharacter(this->Text[this->At]))
    {
      ++this->At;
    }
    if (this->At == begin || this->At - begin > LongestName)
    {
      this->At = begin;
      this->Fail("a name");
    }
    return this->Text.substr(begin, this->At - begin);
  }

  std::string ReadValue()
  {
    const char quote = this->At < this->Text.size() ? this->Text[this->At] : '\0';
    if (quote != '"' && quote != '\'')
    {
      this->Fail("a value in quotes");
    }
    const std::size_t end = this->Text.find_first_of(std::string("<") + quote, this->At + 1);
    if (end == std::string::npos || this->Text[end] == '<')
    {
      this->Fail("a value between two quotes");
    }
    ++this->At;
    std::string value;
    while (this->At < end)
    {
      value += this->Text[this->At] == '&' ? this->ReadEntity() : this->Text[this->At++];
    }
    ++this->At;
    return value;
  }

  char ReadEntity()
  {
    const struct
    {
      const char* text;
      char meaning;
    } entities[] = { { "&lt;", '<' }, { "&gt;", '>' }, { "&amp;", '&' }, { "&quot;", '"' },
      { "&apos;", '\'' } };
    for (const auto& entity : entities)
    {
      if (this->IsNext(entity.text))
      {
        this->Expect(entity.text);
        return entity.meaning;
      }
    }
    // Of characters by their number VTK writes only those of one byte: control characters.
    if (this->IsNext("&#"))
    {
      const std::size_t end = this->Text.find(';', this->At);
      const bool isHex = this->IsNext("&#x");
      const std::size_t begin = this->At + (isHex ? 3 : 2);
      int code = 0;
      for (std::size_t i = begin; i < end && i < begin + 4 && i < this->Text.size(); ++i)
      {
        const int c = std::tolower(static_cast<unsigned char>(this->Text[i]));
        const int digit = c >= '0' && c <= '9' ? c - '0'
          : isHex && c >= 'a' && c <= 'f'      ? c - 'a' + 10
                                               : 1000;
        code = code * (isHex ? 16 : 10) + digit;
      }
      if (end != std::string::npos && end > begin && end <= begin + 4 && code > 0 && code < 128)
      {
        this->At = end + 1;
        return static_cast<char>(code);
      }
    }
    this->Fail("a character such as '&amp;'");
  }

  // Reads the tag that begins an element; whether more of the element follows.
  bool ReadTag(XMLElement& element)
  {
    this->Expect("<");
    element.line = this->LineNumber();
    element.name = this->ReadName();
    while (true)
    {
      const bool isApart = this->At < this->Text.size() && isBlank(this->Text[this->At]);
      this->SkipBlanks();
      if (this->IsNext("/>"))
      {
        this->Expect("/>");
        return false;
      }
      if (this->IsNext(">"))
      {
        this->Expect(">");
        return true;
      }
      if (!isApart)
      {
        this->Fail("'>' or a blank");
      }
      const std::string name = this->ReadName();
      this->SkipBlanks();
      this->Expect("=");
      this->SkipBlanks();
      if (!element.attributes.emplace(name, this->ReadValue()).second)
      {
        this->Fail("one attribute '" + name + "' of '" + element.name + "' before this");
      }
    }
  }

  void ReadElement(XMLElement& element, std::size_t depth)
  {
    const bool goesOn = this->ReadTag(element);
    element.textBegin = element.textEnd = this->At;
    if (element.name == "AppendedData")
    {
      if (depth != 2)
      {
        this->Fail("'AppendedData' as a child of the first element before this");
      }
      this->IsAppended = true;
    }
    if (!goesOn || this->IsAppended)
    {
      return;
    }
    if (depth == MostLevels)
    {
      this->Fail("less elements in each other before this");
    }
    bool isFirst = true;
    while (true)
    {
      this->SkipBlanks();
      const std::size_t end = std::min(this->Text.find('<', this->At), this->Text.size());
      element.hasText = element.hasText || this->At < end;
      this->At = end;
      element.textEnd = isFirst ? end : element.textEnd;
      isFirst = false;
      if (this->SkipBracketed("<!--", "-->") || this->SkipBracketed("<?", "?>"))
      {
        continue;
      }
      if (this->IsNext("</"))
      {
        break;
      }
      if (this->At >= this->Text.size())
      {
        this->Fail("'</" + element.name + ">'");
      }
      element.children.emplace_back();
      this->ReadElement(element.children.back(), depth + 1);
      if (this->IsAppended)
      {
        return;
      }
    }
    const std::string end = "</" + element.name;
    if (!this->IsNext(end.c_str()))
    {
      this->Fail("'" + end + ">'");
    }
    this->At += end.size();
    this->SkipBlanks();
    this->Expect(">");
  }

  const std::string& File;
  const std::string& Text;
  std::size_t At = 0;
  bool IsAppended = false;
  mutable std::size_t Line = 1;
  mutable std::size_t CountedTo = 0;
};
}

const std::string* XMLElement::find(const std::string& attribute) const
{
  const auto place = this->attributes.find(attribute);
  return place == this->attributes.end() ? nullptr : &place->second;
}

XMLElement readXML(const std::string& file, const std::string& text)
{
  return Reader(file, text).read();
}
}
