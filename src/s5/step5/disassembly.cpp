// Blocks with their machine code: parameter lists as the programmer shows them, without the jump
// over them (4.3.2).
#include <fmt/format.h>

#include "step5/call_list.h"
#include "step5/compiler.h"

namespace merker::step5 {

std::vector<mc5::Line> disassemble(const mc5::Program& program, const mc5::Block& block) {
  const std::span<const std::uint16_t> code(block.words);
  std::vector<mc5::Line> lines;
  for (std::uint32_t at = 0; at < code.size();) {
    const auto decoded = mc5::decode(code.subspan(at));
    const std::uint32_t words = decoded ? decoded->words : 1;
    const auto list =
        decoded ? callList(program, block, decoded->instruction, at + words) : std::nullopt;
    lines.push_back({at, code.subspan(at, words + (list ? 1 : 0)), !decoded,
                     decoded ? mc5::text(decoded->instruction) : "illegal"});
    at = list ? list->end : at + words;
    if (!list) continue;
    lines.push_back({list->end, {}, false, fmt::format("NAME : {}", list->called->name)});
    for (const ListedParameter& p : list->parameters)
      lines.push_back({p.offset, code.subspan(p.offset, p.words), false,
                       fmt::format("{:<4} : {}", p.name, p.actual)});
  }
  return lines;
}

}  // namespace merker::step5
