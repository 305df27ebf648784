#include "monitor/program_structure.h"

#include <algorithm>
#include <map>
#include <set>

namespace merker::monitor {
namespace {

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
  if (row.block->kind != BlockKind::DB) return UsedBlock{*row.block, row.instance};
  if (row.instance == row.block->number) return {};
  return UsedBlock{*row.block};
}

}  // namespace

std::vector<BlockStructure> programStructure(const ProgramCode& program,
                                             const std::vector<CrossReference>& references) {
  std::map<BlockId, std::set<UsedBlock>> uses;
  for (const CrossReference& row : references)
    if (const auto used = usedBy(row)) uses[row.place.block].insert(*used);
  std::vector<BlockStructure> list;
  for (const BlockCode& code : program.blocks()) {
    if (code.length() == 0) continue;
    BlockStructure& row = list.emplace_back(BlockStructure{.id = code.id()});
    if (code.s7() != nullptr) row.local = localData(*code.s7());
    const auto& used = uses[row.id];
    row.uses.assign(used.begin(), used.end());
  }
  return list;
}

}  // namespace merker::monitor
