// What is compiled: each block, and each function block once more for each of its calls.
#include <algorithm>
#include <type_traits>

#include "control/compiled_code.h"
#include "control/formal_calls.h"

namespace merker::cnc {
namespace {

using mc5::BlockType;
using sinumerik::Machine;

// As many as a program has: a large function block that is called often would be compiled for
// seconds. Calls beyond that run what all have in common.
constexpr std::size_t kMostVariantWords = 8192;

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

std::vector<sinumerik::Entry> codeBlocks(const Machine& m) {
  std::vector<sinumerik::Entry> blocks;
  for (const BlockType type : {BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb})
    for (const sinumerik::Entry& block : m.blocks.list(type))
      if (block.present) blocks.push_back(block);
  return blocks;
}

}  // namespace

void CompiledCode::clear(const Machine& machine) {
  const std::size_t words = machine.blocks.program().size();
  blocks_.clear();
  variants_.clear();
  variantWords_ = 0;
  sites_.clear();
  entries_.assign(words, {});
  variantOf_.assign(words, 0);
  dataVersion_ = ~std::uint64_t{0};
}

// Who looks at instructions (`apart`) sees each call and its return.
void CompiledCode::compile(Machine& machine, const sinumerik::Environment& environment,
                           const std::vector<bool>& apart) {
  clear(machine);
  const bool seen = std::find(apart.begin(), apart.end(), true) != apart.end();
  Plan plan{machine, environment, apart, !seen};
  const auto blocks = codeBlocks(machine);
  for (const sinumerik::Entry& block : blocks)
    plan.sites.emplace(block.start, sites_.add(machine.blocks, block, environment));
  for (const sinumerik::Entry& block : blocks)
    compileBlock(plan, block, {}, std::span(entries_).subspan(block.start, block.length));
  for (const Call& call : sites_.calls())
    if (call.block.type == BlockType::Fb) compileCall(plan, call);
  nothing_ = write(plan, {}, 0);
  if (nothing_ != nullptr) linkCalls();
}

// The answer is the word of the block with which it goes on.
std::unique_ptr<jit::NativeCode> CompiledCode::write(const Plan& plan,
                                                     std::span<const icode::Region> regions,
                                                     std::size_t words) const {
  const jit::Instructions answers{nullptr, 1, nullptr};
  return jit::compile(regions, words, answers, layoutOf(plan.machine), options_);
}

void CompiledCode::compileBlock(const Plan& plan, const sinumerik::Entry& block,
                                const translate5::Substitutes& substitutes,
                                std::span<Entry> entries) {
  const auto words = wordsOf(plan.machine, block);
  const auto first = plan.apart.begin() + block.start;
  const std::vector<bool> own(first, first + block.length);
  auto regions =
      translate5::translate(words, targetOf(plan.machine, plan.environment), own, substitutes,
                            plan.linked ? &plan.sites.at(block.start) : nullptr);
  for (icode::Region& region : regions) icode::optimise(region);
  auto code = write(plan, regions, words.size());
  if (code == nullptr) return;
  for (const icode::Region& region : regions) entries[region.first] = {code.get(), block.start};
  blocks_.push_back(std::move(code));
}

void CompiledCode::compileCall(const Plan& plan, const Call& call) {
  const std::span<const std::uint16_t> memory = plan.machine.blocks.program();
  if (call.parameters >= memory.size()) return;
  const sinumerik::Entry& block = plan.machine.blocks.find(call.block);
  if (variantWords_ + block.length > kMostVariantWords) return;
  const auto known = substitutes(wordsOf(plan.machine, block), memory.subspan(call.parameters),
                                 plan.environment.variant);
  if (known.empty()) return;
  variantWords_ += block.length;
  Variant& variant = variants_.emplace_back(Variant{block.start, {}});
  variant.entries.resize(block.length);
  compileBlock(plan, block, known, variant.entries);
  variantOf_[call.parameters] = static_cast<std::uint32_t>(variants_.size());
}

void CompiledCode::linkCalls() {
  for (std::size_t i = 0; i < sites_.calls().size(); ++i) {
    const Call& call = sites_.calls()[i];
    const Entry& entry = entryAt({.block = call.block,
                                  .start = call.start,
                                  .next = call.start,
                                  .parameters = call.parameters,
                                  .data = {}});
    const jit::NativeCode& code = entry.code == nullptr ? *nothing_ : *entry.code;
    sites_.site(i).target = code.entrance();
  }
}

}  // namespace merker::cnc
