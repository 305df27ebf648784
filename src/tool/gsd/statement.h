// The statements of a GSD file: one a line, or on several lines that end with a backslash. Comments
// are gone, and what stands in quotation marks is one word.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "source/source_file.h"

namespace merker::gsd {

// What is wrong in a file, and was read nevertheless. It is the maker's, so it has no problem code.
struct Remark {
  std::uint32_t line = 0, column = 0;
  std::string text;
};

struct Word {
  enum class Kind : std::uint8_t { Plain, Text, Sign } kind = Kind::Plain;  // Sign: = ( ) ,
  std::string text;
  std::size_t offset = 0;
};

struct Statement {
  std::string keyword;                 // "Module"; a number that stands alone is one, too
  std::optional<std::string> index{};  // in parentheses: Text(3)
  std::vector<Word> values;            // behind the equals sign, with the commas between them
  bool assigns = false;                // there was an equals sign
  std::size_t offset = 0;
};

std::vector<Statement> readStatements(const source::SourceFile& file, std::vector<Remark>& remarks);

Remark remarkAt(const source::SourceFile& file, std::size_t offset, std::string text);

}  // namespace merker::gsd
