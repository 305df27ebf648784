#include "mc7/disassembly.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/bytes.h"
#include "mc7/instruction.h"
#include "mc7/operand_text.h"

namespace merker::mc7 {
namespace {

constexpr std::size_t kEntryBytes = 4;

bool isCall(const Instruction& instruction) {
  return instruction.operation == Operation::UC || instruction.operation == Operation::CC;
}

// Only FC and SFC have a parameter list; whether a call of a BLOCK_FC parameter has one is not
// established (MC7 section 9), its jump is shown as an instruction.
bool hasParameterList(const Instruction& instruction) {
  const Operand& operand = instruction.operand;
  const bool block =
      operand.kind == OperandKind::Block || operand.kind == OperandKind::BlockIndirect;
  return isCall(instruction) && block &&
         (operand.blockKind == BlockKind::FC || operand.blockKind == BlockKind::SFC);
}

// An entry is a pointer with an area or, for timers, counters and blocks, a number in its first
// word.
std::string entryText(std::uint32_t entry, Mnemonics mnemonics) {
  const Area area = pointerArea(entry);
  constexpr std::uint32_t kUnusedPointerBits = 0x00F80000;
  if (area >= Area::Peripheral && area <= Area::CallerLocal && (entry & kUnusedPointerBits) == 0)
    return pointerText(area, pointerAddress(entry), mnemonics);
  if ((entry & 0xFFFF) == 0) return std::to_string(entry >> 16);
  return fmt::format("DW#16#{:08X}", entry);
}

// Calls `visit` with offset, length, the decoded instruction (null: illegal) and whether it is a
// list entry.
template <typename Visit>
void walk(std::span<const std::uint8_t> code, Visit visit) {
  std::size_t at = 0;
  int entries = 0;  // still to come
  bool afterCall = false;
  while (at < code.size()) {
    if (entries > 0) {
      visit(at, kEntryBytes, nullptr, true);
      at += kEntryBytes;
      --entries;
      continue;
    }
    const auto rest = code.subspan(at);
    const auto decoded = decode(rest);
    const std::size_t length = decoded ? decoded->length : std::min<std::size_t>(2, rest.size());
    visit(at, length, decoded ? &decoded->instruction : nullptr, false);
    if (afterCall) entries = std::max(0, parameterListLength(rest));
    afterCall = decoded && hasParameterList(decoded->instruction);
    at += length;
  }
}

Line makeLine(std::span<const std::uint8_t> code, std::size_t at, std::size_t length,
              const Instruction* instruction, bool entry, Mnemonics mnemonics) {
  Line line{static_cast<std::uint32_t>(at), code.subspan(at, length), LineKind::Illegal, "illegal"};
  if (entry) {
    line.kind = LineKind::Parameter;
    line.text = fmt::format("{:6}{}", "", entryText(loadDWord(line.bytes.data()), mnemonics));
  } else if (instruction != nullptr) {
    line.kind = LineKind::Instruction;
    line.text = text(*instruction, mnemonics);
  }
  return line;
}

}  // namespace

int parameterListLength(std::span<const std::uint8_t> code) {
  if (code.size() < 4 || code[0] != 0x70 || code[1] != 0x0B) return -1;
  const unsigned words = loadWord(&code[2]);
  if (words < 2 || words % 2 != 0 || words * 2 > code.size()) return -1;
  return static_cast<int>(words / 2 - 1);
}

std::vector<Line> disassemble(std::span<const std::uint8_t> code, Mnemonics mnemonics) {
  std::vector<Line> lines;
  walk(code, [&](std::size_t at, std::size_t length, const Instruction* instruction, bool entry) {
    lines.push_back(makeLine(code, at, length, instruction, entry, mnemonics));
  });
  return lines;
}

std::string toString(const Line& line) {
  std::string bytes;
  for (const std::uint8_t byte : line.bytes)
    fmt::format_to(std::back_inserter(bytes), "{:02X}", byte);
  return fmt::format("{:04X}: {:<12}  {}", line.offset, bytes, line.text);
}

std::vector<BlockId> calledBlocks(std::span<const std::uint8_t> code) {
  std::vector<BlockId> blocks;
  walk(code, [&](std::size_t, std::size_t, const Instruction* instruction, bool) {
    if (instruction != nullptr && isCall(*instruction) &&
        instruction->operand.kind == OperandKind::Block)
      blocks.push_back(
          {instruction->operand.blockKind, static_cast<std::uint16_t>(instruction->operand.value)});
  });
  return blocks;
}

std::vector<std::uint32_t> jumpPositions(std::span<const std::uint8_t> code) {
  std::vector<std::uint32_t> positions;
  bool afterCall = false;
  walk(code, [&](std::size_t at, std::size_t, const Instruction* instruction, bool) {
    const bool jump = instruction != nullptr && instruction->operand.kind == OperandKind::Jump;
    if (jump && !afterCall) positions.push_back(static_cast<std::uint32_t>(at / 2));
    afterCall = instruction != nullptr && hasParameterList(*instruction);
  });
  return positions;
}

}  // namespace merker::mc7
