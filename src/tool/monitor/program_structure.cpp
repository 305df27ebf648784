#include "monitor/program_structure.h"

#include <algorithm>
#include <map>
#include <utility>

namespace merker::monitor {
namespace {

// Each with its instance, and whether a CALL is among its uses.
using UsedBlocks = std::map<std::pair<BlockId, std::int32_t>, bool>;

// S7-OBI-01: an organization block has at least its start information; the CPU allots whole words.
std::uint32_t localData(const block::Block& block) {
  constexpr std::uint32_t kStartInformation = 20;
  const bool start = block.id.kind == BlockKind::OB;
  const std::uint32_t bytes = std::max(block.localBytes, start ? kStartInformation : 0u);
  return (bytes + 1) / 2 * 2;
}

// A formal operand of STEP 5 names no block, and the instance of a CALL stands at its block.
std::optional<UsedBlock> usedBy(const CrossReference& row) {
  if (row.formal != 0) return {};
  if (!row.block) {
    if (row.db < 0) return {};
    return UsedBlock{{BlockKind::DB, static_cast<std::uint16_t>(row.db)}};
  }
  if (row.block->kind != BlockKind::DB)
    return UsedBlock{*row.block, row.instance, row.instruction.starts_with("CALL")};
  if (row.instance == row.block->number) return {};
  return UsedBlock{*row.block};
}

}  // namespace

std::vector<BlockStructure> programStructure(const ProgramCode& program,
                                             const std::vector<CrossReference>& references) {
  std::map<BlockId, UsedBlocks> uses;
  for (const CrossReference& row : references)
    if (const auto used = usedBy(row))
      uses[row.place.block][{used->id, used->instance}] |= used->called;
  std::vector<BlockStructure> list;
  for (const BlockCode& code : program.blocks()) {
    if (code.length() == 0) continue;
    BlockStructure& row = list.emplace_back(BlockStructure{.id = code.id()});
    if (code.s7() != nullptr) row.local = localData(*code.s7());
    for (const auto& [used, called] : uses[row.id])
      row.uses.push_back({used.first, used.second, called});
  }
  return list;
}

}  // namespace merker::monitor
