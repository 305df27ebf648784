#include "cnc/compiled_code.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "translate5/translate.h"

namespace merker::cnc {

using mc5::BlockType;
using sinumerik::Machine;

// What compiled code works on: the registers of the running level and where the rest stands.
struct Seat {
  Instant clock, horizon;
  std::uint64_t instructions = 0;
  void* images = nullptr;
  std::uint32_t akku1 = 0, akku2 = 0, unused = 0;
  sinumerik::Displays displays;
  void* data = nullptr;
  std::uint32_t readable = 0, writable = 0;  // bytes
  void* cells = nullptr;
};

namespace {

// Their words are what they begin with.
static_assert(std::is_standard_layout_v<sinumerik::Timer> &&
              std::is_standard_layout_v<sinumerik::Counter>);

// More brackets than that are near the limit of the processor.
constexpr std::size_t kOpenBrackets = 32;

std::uint32_t bytesBetween(const void* from, const void* to) {
  return static_cast<std::uint32_t>(static_cast<const std::byte*>(to) -
                                    static_cast<const std::byte*>(from));
}

#define DISPLAY(bit) static_cast<int>(offsetof(Seat, displays) + offsetof(sinumerik::Displays, bit))
#define FIELD(name) static_cast<int>(offsetof(Seat, name))

jit::Layout layoutOf(const Machine& m) {
  const int none = FIELD(unused);
  return {.clock = FIELD(clock),
          .horizon = FIELD(horizon),
          .image = FIELD(images),
          .instructions = FIELD(instructions),
          .items = {FIELD(akku1), FIELD(akku2), none, none, none, none, DISPLAY(chain),
                    DISPLAY(vke), DISPLAY(status), DISPLAY(orBit), DISPLAY(os), DISPLAY(ov),
                    DISPLAY(anz0), DISPLAY(anz1), none},
          .images = {0, bytesBetween(&m.inputs, &m.outputs), bytesBetween(&m.inputs, &m.flags)},
          .data = {FIELD(data), FIELD(readable), FIELD(writable)},
          .instance = {FIELD(cells), none, none}};
}

#undef DISPLAY
#undef FIELD

translate5::Target targetOf(const Machine& m, const sinumerik::Environment& environment) {
  return {.variant = environment.variant,
          .lastTimer = environment.lastTimer,
          .timerBytes = sizeof(sinumerik::Timer),
          .counters = bytesBetween(&m.timers, &m.counters),
          .counterBytes = sizeof(sinumerik::Counter)};
}

// Data beyond the block can be read to the end of the segment (S5-DB-15), not written (OP-04).
void takeData(Seat& seat, Machine& m) {
  const sinumerik::OpenData& open = m.frame().data;
  auto& memory = m.blocks.data();
  seat.data = nullptr;
  seat.readable = seat.writable = 0;
  if (!open.open || std::uint64_t{open.start} + open.length > memory.size()) return;
  seat.data = memory.data() + open.start;
  seat.readable = static_cast<std::uint32_t>(2 * (memory.size() - open.start));
  seat.writable = 2 * open.length;
}

}  // namespace

// Who looks at instructions (`apart`) sees each call and its return.
void CompiledCode::compile(Machine& machine, const sinumerik::Environment& environment,
                           const std::vector<bool>& apart) {
  blocks_.clear();
  entries_.assign(machine.blocks.program().size(), {});
  const bool seen = std::find(apart.begin(), apart.end(), true) != apart.end();
  for (const BlockType type : {BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb})
    for (const sinumerik::Entry& block : machine.blocks.list(type)) {
      if (!block.present) continue;
      compileBlock(machine, block, environment, apart);
      if (!seen) linkBlock(machine, block, environment);
    }
}

void CompiledCode::linkBlock(const Machine& machine, const sinumerik::Entry& block,
                             const sinumerik::Environment& environment) {
  const auto words = std::span(machine.blocks.program()).subspan(block.start, block.length);
  for (std::uint32_t at = 0; at < words.size(); ++at)
    entries_[block.start + at].link = linkAt(words.subspan(at), environment);
}

void CompiledCode::compileBlock(Machine& machine, const sinumerik::Entry& block,
                                const sinumerik::Environment& environment,
                                const std::vector<bool>& apart) {
  const auto words = std::span(machine.blocks.program()).subspan(block.start, block.length);
  const std::vector<bool> own(apart.begin() + block.start,
                              apart.begin() + block.start + block.length);
  auto regions = translate5::translate(words, targetOf(machine, environment), own);
  for (icode::Region& region : regions) icode::optimise(region);
  // The answer is the word of the block with which it goes on.
  const jit::Instructions answers{nullptr, 1, nullptr};
  auto code = jit::compile(regions, words.size(), answers, layoutOf(machine), options_.jit);
  if (code == nullptr) return;
  for (const icode::Region& region : regions)
    if (region.instructions >= options_.shortestEntry)
      entries_[block.start + region.first] = {code.get(), block.start, {}};
  blocks_.push_back(std::move(code));
}

// False: the processor is next. Of code and link the code comes first: it knows whether a condition
// is met.
bool CompiledCode::goOn(Seat& seat, Machine& m) const {
  sinumerik::Frame& frame = m.frame();
  if (frame.next >= entries_.size()) return false;
  const Entry& entry = entries_[frame.next];
  const std::uint64_t before = seat.instructions;
  if (entry.code != nullptr) {
    const void* const answer = entry.code->run(&seat, frame.next - entry.start);
    frame.next = entry.start + static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(answer));
    if (seat.instructions != before) return true;
  }
  if (!entry.link || seat.clock >= seat.horizon || !follow(*entry.link, m, seat.displays))
    return false;
  seat.clock = seat.clock + entry.link->time;
  ++seat.instructions;
  takeData(seat, m);
  return true;
}

std::uint64_t CompiledCode::run(Machine& m, Instant horizon) {
  sinumerik::Registers& registers = m.registers();
  if (registers.brackets.size() > kOpenBrackets) return 0;
  Seat seat{.clock = m.clock,
            .horizon = horizon,
            .images = &m.inputs,
            .akku1 = registers.akku1,
            .akku2 = registers.akku2,
            .displays = registers.displays,
            .cells = &m.timers};
  takeData(seat, m);
  while (goOn(seat, m)) {
  }
  if (seat.instructions == 0) return 0;
  m.clock = seat.clock;
  registers.akku1 = seat.akku1;
  registers.akku2 = seat.akku2;
  registers.displays = seat.displays;
  instructions_ += seat.instructions;
  return seat.instructions;
}

}  // namespace merker::cnc
