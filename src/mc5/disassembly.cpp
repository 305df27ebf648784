#include "mc5/disassembly.h"

#include <fmt/format.h>

#include "mc5/instruction.h"

namespace merker::mc5 {

std::vector<Line> disassemble(std::span<const std::uint16_t> code) {
  std::vector<Line> lines;
  for (std::size_t at = 0; at < code.size();) {
    const auto decoded = decode(code.subspan(at));
    const std::size_t words = decoded ? decoded->words : 1;
    lines.push_back({static_cast<std::uint32_t>(at), code.subspan(at, words), !decoded,
                     decoded ? text(decoded->instruction) : "illegal"});
    at += words;
  }
  return lines;
}

std::string toString(const Line& line) {
  std::string words;
  for (const std::uint16_t word : line.words) words += fmt::format("{:04X} ", word);
  return fmt::format("{:04X}: {:<16} {}", line.offset, words, line.text);
}

}  // namespace merker::mc5
