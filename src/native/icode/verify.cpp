#include <fmt/format.h>

#include "icode/region.h"

namespace merker::icode {
namespace {

std::string wrongArgument(const Region& region, std::size_t at, Value argument, bool wanted) {
  if (wanted != (argument != kNoValue)) return fmt::format("{}: number of arguments", at);
  if (!wanted) return {};
  if (argument >= at) return fmt::format("{}: argument {} is not defined yet", at, argument);
  if (info(region.ops[argument].code).result == Result::Nothing)
    return fmt::format("{}: argument {} is not a value", at, argument);
  return {};
}

bool isEnd(Opcode code) {
  return code == Opcode::Leave || code == Opcode::Call || code == Opcode::Return;
}

std::string wrongExit(const Region& region, std::size_t at, std::uint32_t number) {
  if (number >= region.exits.size()) return fmt::format("{}: no exit {}", at, number);
  const Exit& exit = region.exits[number];
  if (exit.firstState + exit.states > region.states.size() ||
      exit.firstByte + exit.bytes > region.bytes.size())
    return fmt::format("exit {}: beyond the lists", number);
  if (exit.inside > region.inlined.size())
    return fmt::format("exit {}: no block {} stands in the region", number, exit.inside);
  for (std::uint32_t i = 0; i < exit.states; ++i)
    if (region.states[exit.firstState + i].value >= at)
      return fmt::format("exit {}: a register is not defined yet", number);
  for (std::uint32_t i = 0; i < exit.bytes; ++i)
    if (region.bytes[exit.firstByte + i].value >= at)
      return fmt::format("exit {}: a byte is not defined yet", number);
  return {};
}

}  // namespace

std::string verify(const Region& region) {
  if (region.ops.empty() || !isEnd(region.ops.back().code)) return "the end has no leave";
  for (std::size_t i = 0; i < region.ops.size(); ++i) {
    const Op& op = region.ops[i];
    const unsigned count = info(op.code).arguments;
    const Value arguments[] = {op.a, op.b, op.c};
    for (unsigned k = 0; k < 3; ++k) {
      std::string wrong = wrongArgument(region, i, arguments[k], k < count);
      if (!wrong.empty()) return wrong;
    }
    for (const std::uint32_t number : ExitsOf(region, op)) {
      std::string wrong = wrongExit(region, i, number);
      if (!wrong.empty()) return wrong;
    }
  }
  return {};
}

}  // namespace merker::icode
