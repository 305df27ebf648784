#include "monitor/cross_reference.h"

#include <algorithm>
#include <tuple>

#include "monitor/cross_reference_walk.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;

// Inputs, outputs, flags, periphery, timers, counters, data blocks, blocks.
int rank(const CrossReference& r) {
  if (r.key.kind == OperandKind::Timer) return 4;
  if (r.key.kind == OperandKind::Counter) return 5;
  if (r.key.kind == OperandKind::Block) return 7 + static_cast<int>(r.key.blockKind);
  if (r.db >= 0 || r.key.area == Area::DataBlock || r.key.area == Area::Instance) return 6;
  return r.key.area == Area::Input    ? 0
         : r.key.area == Area::Output ? 1
         : r.key.area == Area::Flag   ? 2
                                      : 3;
}

}  // namespace

std::string_view name(Use use) {
  constexpr std::string_view kNames[] = {"R", "W", "RW", "-"};
  return kNames[static_cast<std::size_t>(use)];
}

std::vector<CrossReference> crossReferences(const block::Program& program,
                                            const source::SymbolTable& symbols,
                                            const CrossReferenceOptions& options) {
  std::vector<CrossReference> list;
  for (const auto& [id, block] : program)
    if (!block.code.empty()) CrossReferenceWalk(block, {program, symbols, options, list}).run();
  std::stable_sort(list.begin(), list.end(), [](const CrossReference& a, const CrossReference& b) {
    return std::tuple(rank(a), a.db, a.key.value, a.key.width) <
           std::tuple(rank(b), b.db, b.key.value, b.key.width);
  });
  return list;
}

}  // namespace merker::monitor
