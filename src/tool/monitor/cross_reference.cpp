#include "monitor/cross_reference.h"

#include <algorithm>
#include <tuple>

#include "monitor/step5_references.h"
#include "monitor/step7_references.h"

namespace merker::monitor {
namespace {

using address::OperandKind;

// Blocks as the S7 sorts them, those of STEP 5 behind OB.
constexpr BlockKind kBlocks[] = {BlockKind::OB,  BlockKind::PB,  BlockKind::SB,
                                 BlockKind::DB,  BlockKind::SDB, BlockKind::FC,
                                 BlockKind::SFC, BlockKind::FB,  BlockKind::SFB};

// Inputs, outputs, flags, periphery, timers, counters, data blocks, blocks, formal operands.
std::ptrdiff_t rank(const CrossReference& r) {
  if (r.formal != 0) return 7 + std::ssize(kBlocks);
  if (r.block) return 7 + (std::ranges::find(kBlocks, r.block->kind) - std::begin(kBlocks));
  if (r.key.kind == OperandKind::Timer) return 4;
  if (r.key.kind == OperandKind::Counter) return 5;
  if (r.db >= 0 || r.key.area == Area::DataBlock || r.key.area == Area::Instance) return 6;
  return r.key.area == Area::Input    ? 0
         : r.key.area == Area::Output ? 1
         : r.key.area == Area::Flag   ? 2
                                      : 3;
}

auto order(const CrossReference& r) {
  return std::tuple(rank(r), r.db, r.block ? r.block->number : r.key.value, r.key.width, r.formal);
}

// What of a program the references are taken from, and where they go.
struct Search {
  const source::SymbolTable& symbols;
  const CrossReferenceOptions& options;
  std::vector<CrossReference> list{};

  void operator()(const block::Program& program) {
    for (const auto& [id, block] : program)
      if (!block.code.empty()) Step7References(block, {program, symbols, options, list}).run();
  }
  void operator()(const mc5::Program& program) {
    FormalUses formals;
    for (const auto& [id, block] : program)
      if (codeLength(block) > 0) Step5References(block, {program, symbols, formals, list}).run();
  }
};

}  // namespace

std::string_view name(Use use) {
  constexpr std::string_view kNames[] = {"R", "W", "RW", "-"};
  return kNames[static_cast<std::size_t>(use)];
}

std::vector<CrossReference> crossReferences(const ProgramCode& program,
                                            const source::SymbolTable& symbols,
                                            const CrossReferenceOptions& options) {
  Search search{symbols, options};
  program.visit(search);
  std::ranges::stable_sort(search.list, {}, order);
  return std::move(search.list);
}

}  // namespace merker::monitor
