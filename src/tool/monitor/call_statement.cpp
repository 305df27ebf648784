#include "monitor/call_statement.h"

#include <fmt/format.h>

#include "mc7/disassembly.h"
#include "mc7/instruction.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;
using mc7::Operation;

// BLD at the beginning: an FC or SFC; an FB or SFB, with its data block or as multiple instance.
constexpr bool opensFunction(std::uint32_t mark) { return mark == 1 || mark == 7; }
constexpr bool opensInstance(std::uint32_t mark) {
  return mark == 3 || mark == 9 || mark == 14 || mark == 16;
}

// The number of its data block does not stand in the code.
constexpr bool multiple(std::uint32_t mark) { return mark >= 14; }

std::uint32_t display(const mc7::Instruction& one) {
  return one.operation == Operation::BLD ? one.operand.value : 0;
}

// A large composite parameter of a function block is copied by SFC 20: another call inside.
bool calls(const mc7::Instruction& one, bool functionBlock) {
  if (one.operation != Operation::UC || one.operand.kind != OperandKind::Block) return false;
  const BlockKind kind = one.operand.blockKind;
  return functionBlock == (kind == BlockKind::FB || kind == BlockKind::SFB);
}

std::string name(const mc7::Operand& block) {
  return toString(BlockId{block.blockKind, static_cast<std::uint16_t>(block.value)});
}

}  // namespace

std::optional<CallStatement> callStatement(std::span<const std::uint8_t> code, std::uint32_t at,
                                           std::uint32_t end, Mnemonics mnemonics) {
  std::uint32_t kind = 0;
  std::string target, instance;
  std::int32_t number = -1;
  for (const mc7::Line& line : mc7::disassemble(code.subspan(at, end - at), mnemonics)) {
    const auto decoded = mc7::decode(line.bytes);
    if (!decoded || line.kind != mc7::LineKind::Instruction) continue;
    const mc7::Instruction& one = decoded->instruction;
    if (kind == 0) kind = display(one);
    if (!opensFunction(kind) && !opensInstance(kind)) return std::nullopt;
    if (calls(one, opensInstance(kind))) target = name(one.operand);
    const bool opened = one.operation == Operation::OPEN && one.operand.kind == OperandKind::Block;
    // The first one: those of actual parameters follow.
    if (opened && one.operand.reg == 1 && instance.empty() && target.empty() && !multiple(kind)) {
      instance = ", " + name(one.operand);
      number = static_cast<std::int32_t>(one.operand.value);
    }
    if (display(one) == kind + 1 && !target.empty())
      return CallStatement{at + line.offset + decoded->length,
                           fmt::format("CALL  {}{}", target, instance), number};
  }
  return std::nullopt;
}

}  // namespace merker::monitor
