#include "mc5/disassembly.h"

#include <fmt/format.h>

#include "mc5/constant.h"
#include "mc5/parameter_list.h"

namespace merker::mc5 {
namespace {

using Code = std::span<const std::uint16_t>;

// What a parameter means only the called block knows.
Line parameter(Code code, std::uint32_t at) {
  return {at, code.subspan(at, 1), false,
          constantText({.kind = OperandKind::Constant, .value = code[at]})};
}

}  // namespace

std::vector<Line> disassemble(Code code) {
  std::vector<Line> lines;
  for (std::uint32_t at = 0; at < code.size();) {
    const auto decoded = decode(code.subspan(at));
    const std::uint32_t words = decoded ? decoded->words : 1;
    lines.push_back(
        {at, code.subspan(at, words), !decoded, decoded ? text(decoded->instruction) : "illegal"});
    at += words;
    if (!decoded || !callsFunctionBlock(decoded->instruction)) continue;
    const auto end = endOfList(code, at);
    if (!end) continue;
    lines.push_back({at, code.subspan(at, 1), false, text(decode(code.subspan(at))->instruction)});
    for (++at; at < *end; ++at) lines.push_back(parameter(code, at));
  }
  return lines;
}

std::string toString(const Line& line) {
  std::string words;
  for (const std::uint16_t word : line.words) words += fmt::format("{:04X} ", word);
  if (words.empty()) return fmt::format("{:<22} {}", "", line.text);
  return fmt::format("{:04X}: {:<16} {}", line.offset, words, line.text);
}

}  // namespace merker::mc5
