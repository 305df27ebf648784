#include "monitor/step5_code.h"

#include "mc5/block_id.h"
#include "mc5/parameter_list.h"
#include "mc5/resident_blocks.h"

namespace merker::monitor {
namespace {

// B DW, B MW: executed as one with the next instruction (S5-PROC-01). B =X has none.
bool processesNext(const mc5::Instruction& one) {
  return one.operation == mc5::Operation::SUBSTITUTE &&
         one.operand.kind == mc5::OperandKind::Memory;
}

}  // namespace

std::vector<Step5Instruction> step5Instructions(const mc5::Block& block) {
  const std::span<const std::uint16_t> code(block.words);
  std::vector<Step5Instruction> result;
  for (std::uint32_t at = 0; at < codeLength(block);) {
    const auto decoded = mc5::decode(code.subspan(at));
    const std::uint32_t behind = at + (decoded ? decoded->words : 1);
    std::uint32_t next = behind;
    std::span<const std::uint16_t> list;
    if (decoded && mc5::callsFunctionBlock(decoded->instruction)) {
      next = mc5::endOfList(code, behind).value_or(behind);
      if (next != behind) list = code.subspan(behind + 1, next - behind - 1);
    }
    if (decoded) result.push_back({at, next, decoded->instruction, list});
    at = next;
  }
  return result;
}

const mc5::Block* calledFunctionBlock(const mc5::Program& program, const mc5::Instruction& call) {
  if (!mc5::callsFunctionBlock(call)) return nullptr;
  const auto number = static_cast<std::uint16_t>(call.operand.value);
  const auto own = program.find({mc5::BlockType::Fb, number});
  return own != program.end() ? &own->second : mc5::findResident(number);
}

BlockId blockId(const mc5::Block& block) { return mc5::neutralId(block.id); }

std::uint32_t codeLength(const mc5::Block& block) {
  const bool data = block.id.type == mc5::BlockType::Db;
  return data ? 0 : static_cast<std::uint32_t>(block.words.size());
}

// What stands in front of the first NETZWERK line is a network, too: *** or BLD 255 ends it.
std::size_t unnamedNetworks(const mc5::Block& block) {
  const bool named = !block.networks.empty() && block.networks.front().offset == 0;
  return named || codeLength(block) == 0 ? 0 : 1;
}

std::uint32_t instructionStart(const mc5::Block& block, std::uint32_t word) {
  std::uint32_t at = 0;
  bool processed = false;
  for (const Step5Instruction& one : step5Instructions(block)) {
    if (one.offset > word) break;
    if (!processed) at = one.offset;
    processed = !processed && processesNext(one.instruction);
  }
  return at;
}

std::uint32_t processedInstruction(const mc5::Block& block, std::uint32_t word) {
  for (const Step5Instruction& one : step5Instructions(block))
    if (one.offset == word && processesNext(one.instruction) && one.next < codeLength(block))
      return one.next;
  return word;
}

std::span<const BlockKind> blockKinds(const mc5::Program&) {
  static constexpr BlockKind kKinds[] = {BlockKind::OB, BlockKind::PB, BlockKind::SB, BlockKind::FB,
                                         BlockKind::DB};
  return kKinds;
}

const mc5::Block* findBlock(const mc5::Program& program, BlockId id) {
  const auto own = mc5::step5Id(id);
  const auto found = own ? program.find(*own) : program.end();
  return found == program.end() ? nullptr : &found->second;
}

}  // namespace merker::monitor
