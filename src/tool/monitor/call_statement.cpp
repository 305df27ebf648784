#include "monitor/call_statement.h"

#include <fmt/format.h>

#include "mc7/disassembly.h"
#include "mc7/instruction.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;
using mc7::Operation;

constexpr std::uint32_t kFunction = 1, kFunctionBlock = 3;  // BLD at the beginning

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
  for (const mc7::Line& line : mc7::disassemble(code.subspan(at, end - at), mnemonics)) {
    const auto decoded = mc7::decode(line.bytes);
    if (!decoded || line.kind != mc7::LineKind::Instruction) continue;
    const mc7::Instruction& one = decoded->instruction;
    if (kind == 0) kind = display(one);
    if (kind != kFunction && kind != kFunctionBlock) return std::nullopt;
    if (calls(one, kind == kFunctionBlock)) target = name(one.operand);
    const bool opened = one.operation == Operation::OPEN && one.operand.kind == OperandKind::Block;
    if (opened && one.operand.reg == 1 && target.empty()) instance = ", " + name(one.operand);
    if (display(one) == kind + 1 && !target.empty())
      return CallStatement{at + line.offset + decoded->length,
                           fmt::format("CALL  {}{}", target, instance)};
  }
  return std::nullopt;
}

}  // namespace merker::monitor
