#include "control/compiled_code.h"

namespace merker::cnc {
namespace {

using mc5::BlockType;
using sinumerik::Machine;

// More brackets than that are near the limit of the processor.
constexpr std::size_t kOpenBrackets = 32;

}  // namespace

// As the running call sees the block, or as all of them do.
const CompiledCode::Entry& CompiledCode::entryAt(const sinumerik::Frame& frame) const {
  static const Entry kNone;
  if (frame.next >= entries_.size()) return kNone;
  const std::uint32_t number =
      frame.parameters < variantOf_.size() ? variantOf_[frame.parameters] : 0;
  if (number == 0) return entries_[frame.next];
  const Variant& variant = variants_[number - 1];
  const std::uint32_t at = frame.next - variant.start;
  const bool inside = variant.start == frame.start && at < variant.entries.size();
  return inside ? variant.entries[at] : entries_[frame.next];
}

std::size_t CompiledCode::bytes() const {
  std::size_t sum = 0;
  for (const auto& code : blocks_) sum += code->size();
  return sum;
}

void CompiledCode::listDataBlocks(Machine& m) {
  if (dataVersion_ == m.blocks.version()) return;
  dataVersion_ = m.blocks.version();
  dataBlocks_.clear();
  std::uint16_t number = 0;
  for (const sinumerik::Entry& entry : m.blocks.list(BlockType::Db))
    dataBlocks_.push_back(openBlock(m, {entry.present, number++, entry.start, entry.length}));
}

void CompiledCode::takeIn(Machine& m, Instant horizon) {
  listDataBlocks(m);
  const sinumerik::Registers& registers = m.registers();
  seat_.clock = m.clock;
  seat_.horizon = horizon;
  seat_.instructions = 0;
  seat_.images = &m.inputs;
  seat_.akku1 = registers.akku1;
  seat_.akku2 = registers.akku2;
  seat_.displays = registers.displays;
  seat_.cells = &m.timers;
  seat_.sites = sites_.sites();
  seat_.dataBlocks = dataBlocks_.data();
  takeStack(m);
}

void CompiledCode::takeStack(Machine& m) {
  const auto& frames = m.level().frames;
  seat_.first = seat_.frames.data();
  seat_.last = seat_.first + (seat_.frames.size() - 1);
  seat_.top = seat_.first + (frames.size() - 1);
  seat_.open = openBlock(m, frames.back().data);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Entry& entry = entryAt(frames[i]);
    const std::uint32_t word = frames[i].next - entry.start;
    starts_[i] = entry.start;
    if (i + 1 == frames.size()) break;
    seat_.found[i].resume = word;
    seat_.frames[i].open = openBlock(m, frames[i].data);
    seat_.frames[i + 1].site = &seat_.found[i];
    seat_.frames[i + 1].back =
        entry.code == nullptr ? nothing_->entries()[0] : entry.code->entries()[word];
  }
}

void CompiledCode::giveBack(Machine& m, std::uint32_t word) const {
  sinumerik::Registers& registers = m.registers();
  m.clock = seat_.clock;
  registers.akku1 = seat_.akku1;
  registers.akku2 = seat_.akku2;
  registers.displays = seat_.displays;
  giveStack(m.level().frames);
  const std::size_t running = m.level().frames.size() - 1;
  const bool called = running > 0 && sites_.find(seat_.top->site) != nullptr;
  m.frame().next = word + (called ? m.frame().start : starts_[running]);
}

// Blocks that still wait for what they called before stand there as they did.
void CompiledCode::giveStack(std::vector<sinumerik::Frame>& frames) const {
  frames.resize(static_cast<std::size_t>(seat_.top - seat_.first) + 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const jit::Frame& frame = seat_.frames[i];
    frames[i].data = openData(i + 1 == frames.size() ? seat_.open : frame.open);
    const Call* const call = i == 0 ? nullptr : sites_.find(frame.site);
    if (call == nullptr) continue;
    frames[i - 1].next = call->next;
    frames[i].block = call->block;
    frames[i].start = call->start;
    frames[i].parameters = call->parameters;
  }
}

std::uint64_t CompiledCode::run(Machine& m, Instant horizon) {
  if (nothing_ == nullptr || m.registers().brackets.size() > kOpenBrackets) return 0;
  const sinumerik::Frame& frame = m.frame();
  const Entry entry = entryAt(frame);
  if (entry.code == nullptr) return 0;
  takeIn(m, horizon);
  const void* const answer = entry.code->run(&seat_, frame.next - entry.start);
  if (seat_.instructions == 0) return 0;
  giveBack(m, static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(answer)));
  instructions_ += seat_.instructions;
  return seat_.instructions;
}

}  // namespace merker::cnc
