#include <fmt/format.h>

#include "icode/region.h"

namespace merker::icode {
namespace {

constexpr std::string_view kItemNames[] = {"accu1", "accu2", "accu3", "accu4", "ar1",
                                           "ar2",   "er",    "rlo",   "sta",   "or",
                                           "os",    "ov",    "cc0",   "cc1",   "br"};
constexpr std::string_view kSpaceNames[] = {"E", "A", "M", "DB", "DI", "L"};

std::string_view name(Item item) { return kItemNames[static_cast<std::size_t>(item)]; }
std::string_view name(Space space) { return kSpaceNames[static_cast<std::size_t>(space)]; }

std::string exitText(const Region& region, const Exit& exit) {
  std::string text =
      fmt::format(" -> {} after {} instructions, {} ns:", exit.to, exit.instructions, exit.cost);
  if (exit.swapped) text += " TDB";
  if (exit.inside != 0) text += fmt::format(" inside {}", exit.inside);
  if (exit.way == Way::Call) text += fmt::format(" call {}", exit.site);
  if (exit.way == Way::Return) text += " return";
  for (std::uint32_t i = 0; i < exit.bytes; ++i) {
    const ByteWrite& write = region.bytes[exit.firstByte + i];
    text += fmt::format(" {}B{}=%{}", name(write.space), write.place, write.value);
  }
  for (std::uint32_t i = 0; i < exit.states; ++i) {
    const StateWrite& write = region.states[exit.firstState + i];
    text += fmt::format(" {}=%{}", name(write.item), write.value);
  }
  return text;
}

}  // namespace

std::string print(const Region& region) {
  std::string text = fmt::format("region at {}, {} instructions, {} ns ahead\n", region.first,
                                 region.instructions, region.ahead);
  for (std::size_t i = 0; i < region.ops.size(); ++i) {
    const Op& op = region.ops[i];
    text += fmt::format("{} %{} = {}", op.needed ? ' ' : '-', i, info(op.code).text);
    for (const Value value : {op.a, op.b, op.c})
      if (value != kNoValue) text += fmt::format(" %{}", value);
    if (op.code == Opcode::Get) text += fmt::format(" {}", name(op.item));
    if (op.code >= Opcode::Base && op.code <= Opcode::WriteLimit)
      text += fmt::format(" {} {}", name(op.space), op.place);
    if (op.code < Opcode::Guard) text += fmt::format(" {:#x}", op.number);
    for (const std::uint32_t exit : ExitsOf(region, op))
      text += exitText(region, region.exits[exit]);
    text += '\n';
  }
  return text;
}

}  // namespace merker::icode
