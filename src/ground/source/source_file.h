// A source text in memory, and how a problem in it is shown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/problem.h"
#include "base/result.h"
#include "base/text.h"

namespace merker::source {

class SourceFile {
 public:
  // `name` is the path as the user gave it; it appears in problems.
  SourceFile(std::string name, std::string utf8);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  // Line 1 … lineCount, without its end of line.
  std::string_view line(std::uint32_t number) const;
  std::uint32_t lineCount() const { return static_cast<std::uint32_t>(starts_.size()); }
  // Byte offset to line and column (in characters); `length` in bytes of the same line.
  Position position(std::size_t offset, std::size_t length = 1) const;

 private:
  std::string name_;
  std::string text_;
  std::size_t characters(std::size_t from, std::size_t to) const;

  std::vector<std::size_t> starts_;
  // Continuation bytes of UTF-8 before each kilobyte of the text: columns of very long lines
  // without counting from their start. Empty for a pure ASCII text.
  std::vector<std::uint32_t> continuations_;
};

constexpr std::size_t kLargestSource = 16, kLargestTrace = 256;  // MB
// Reads and decodes a text file. P0101 unreadable, P0102 binary, P0103 above `largest` MB.
Result<SourceFile> readSource(const std::string& path, std::size_t largest = kLargestSource);

// "file:line:column: error: message [P0214]", the line, a caret under the place. The line only if
// `file` is given.
std::string format(const Problem& problem, const SourceFile* file);

}  // namespace merker::source
