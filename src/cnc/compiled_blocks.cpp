// What is compiled: each block, and each function block once more for each of its calls.
#include <algorithm>
#include <type_traits>

#include "cnc/compiled_code.h"
#include "cnc/formal_calls.h"
#include "cnc/seat.h"

namespace merker::cnc {
namespace {

using mc5::BlockType;
using sinumerik::Machine;

// Their words are what they begin with.
static_assert(std::is_standard_layout_v<sinumerik::Timer> &&
              std::is_standard_layout_v<sinumerik::Counter>);

translate5::Target targetOf(const Machine& m, const sinumerik::Environment& environment) {
  return {.variant = environment.variant,
          .lastTimer = environment.lastTimer,
          .timerBytes = sizeof(sinumerik::Timer),
          .counters = bytesBetween(&m.timers, &m.counters),
          .counterBytes = sizeof(sinumerik::Counter)};
}

std::span<const std::uint16_t> wordsOf(const Machine& m, const sinumerik::Entry& block) {
  return std::span(m.blocks.program()).subspan(block.start, block.length);
}

}  // namespace

void CompiledCode::compile(Machine& machine, const sinumerik::Environment& environment,
                           const std::vector<bool>& apart) {
  const std::size_t words = machine.blocks.program().size();
  blocks_.clear();
  variants_.clear();
  links_.clear();
  entries_.assign(words, {});
  variantOf_.assign(words, 0);
  for (const BlockType type : {BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb})
    for (const sinumerik::Entry& block : machine.blocks.list(type)) {
      if (!block.present) continue;
      compileBlock(machine, block, environment, apart, {},
                   std::span(entries_).subspan(block.start, block.length));
      compileCalls(machine, block, environment, apart);
    }
}

void CompiledCode::compileBlock(Machine& machine, const sinumerik::Entry& block,
                                const sinumerik::Environment& environment,
                                const std::vector<bool>& apart,
                                const translate5::Substitutes& substitutes,
                                std::span<Entry> entries) {
  const auto words = wordsOf(machine, block);
  const std::vector<bool> own(apart.begin() + block.start,
                              apart.begin() + block.start + block.length);
  auto regions = translate5::translate(words, targetOf(machine, environment), own, substitutes);
  for (icode::Region& region : regions) icode::optimise(region);
  // The answer is the word of the block with which it goes on.
  const jit::Instructions answers{nullptr, 1, nullptr};
  auto code = jit::compile(regions, words.size(), answers, layoutOf(machine), options_);
  if (code == nullptr) return;
  for (const icode::Region& region : regions) entries[region.first] = {code.get(), block.start};
  blocks_.push_back(std::move(code));
}

// The ways out of a block. Who looks at instructions (`apart`) sees each call and its return.
void CompiledCode::compileCalls(Machine& machine, const sinumerik::Entry& block,
                                const sinumerik::Environment& environment,
                                const std::vector<bool>& apart) {
  const bool seen = std::find(apart.begin(), apart.end(), true) != apart.end();
  const auto words = wordsOf(machine, block);
  for (std::uint32_t at = 0; at < words.size(); ++at) {
    const auto link = linkAt(words.subspan(at), environment);
    if (!link) continue;
    const std::uint32_t word = block.start + at;
    if (!seen) {
      links_.push_back(*link);
      entries_[word].link = static_cast<std::uint32_t>(links_.size());
    }
    const bool calls =
        link->operation == mc5::Operation::CALL || link->operation == mc5::Operation::CALL_IF;
    if (calls && link->block.type == BlockType::Fb)  // the list stands behind a jump over it
      compileCall(machine, link->block, word + link->words + 1, environment, apart);
  }
}

void CompiledCode::compileCall(Machine& machine, mc5::BlockId id, std::uint32_t parameters,
                               const sinumerik::Environment& environment,
                               const std::vector<bool>& apart) {
  const sinumerik::Entry& block = machine.blocks.find(id);
  const std::span<const std::uint16_t> memory = machine.blocks.program();
  if (!block.present || parameters >= memory.size()) return;
  const auto known =
      substitutes(wordsOf(machine, block), memory.subspan(parameters), environment.variant);
  if (known.empty()) return;
  Variant& variant = variants_.emplace_back(Variant{block.start, {}});
  variant.entries.resize(block.length);
  compileBlock(machine, block, environment, apart, known, variant.entries);
  variantOf_[parameters] = static_cast<std::uint32_t>(variants_.size());
}

}  // namespace merker::cnc
