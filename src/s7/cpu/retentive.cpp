// What outlives a power failure (S7-MEM-02, S7-CPU-28), handed out and taken back.
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

using block::RetentiveCounter;
using block::RetentiveData;
using block::RetentiveDataBlock;
using block::RetentiveEvent;
using block::RetentiveTimer;

RetentiveTimer toRetentive(const S5Timer& timer, Duration standing) {
  return {.kind = static_cast<std::uint8_t>(timer.kind),
          .startEdge = timer.startEdge,
          .enableEdge = timer.enableEdge,
          .started = timer.started,
          .held = timer.held,
          .base = timer.base,
          .frozen = timer.frozen,
          .end = timer.started ? (timer.end + standing).ns : 0};
}

S5Timer toTimer(const RetentiveTimer& timer, Duration shift) {
  return {.kind = static_cast<S5Timer::Kind>(timer.kind),
          .startEdge = timer.startEdge,
          .enableEdge = timer.enableEdge,
          .started = timer.started,
          .held = timer.held,
          .base = timer.base,
          .frozen = timer.frozen,
          .end = Instant{timer.end} + shift};
}

RetentiveCounter toRetentive(const S5Counter& c) {
  return {c.count, c.setEdge, c.upEdge, c.downEdge, c.enableEdge};
}

S5Counter toCounter(const RetentiveCounter& c) {
  return {c.count, c.setEdge, c.upEdge, c.downEdge, c.enableEdge};
}

// Off after power off (S7-SFC-03), with what it had counted by then.
RuntimeMeter toMeter(const block::RetentiveMeter& meter, const RetentiveData& data) {
  return {.counted = meter.counted + (meter.running ? data.now - meter.since : 0)};
}

// Into the vectors that are there: nothing is allocated cycle after cycle.
void copyBlocks(const std::vector<DataBlock>& from, bool all, std::vector<RetentiveDataBlock>& to) {
  std::size_t count = 0;
  for (std::size_t number = 0; number < from.size(); ++number) {
    const DataBlock& block = from[number];
    if (!block.loaded || !(all || block.retentive)) continue;
    if (to.size() == count) to.emplace_back();
    RetentiveDataBlock& copy = to[count++];
    copy.number = static_cast<std::uint16_t>(number);
    copy.madeByProgram = block.madeByProgram;
    copy.bytes = block.data;
  }
  to.resize(count);
}

void restoreBlock(const RetentiveDataBlock& from, bool all, DataBlocks& blocks) {
  if (from.madeByProgram && blocks.find(from.number) == nullptr)
    blocks.create(from.number, static_cast<std::uint32_t>(from.bytes.size()));
  DataBlock* block = blocks.find(from.number);
  if (block != nullptr && (all || block->retentive) && block->data.size() == from.bytes.size())
    std::copy(from.bytes.begin(), from.bytes.end(), block->data.begin());  // where it is
}

}  // namespace

RetentiveEvent toRetentive(const DiagnosticEvent& event) {
  return {.event = event.event,
          .time = event.time.ns,
          .text = event.text,
          .placeKnown = event.place.known,
          .block = event.place.block,
          .offset = event.place.offset,
          .info = event.info,
          .stamp = event.stamp};
}

DiagnosticEvent toEvent(const RetentiveEvent& event, Duration shift) {
  return {.event = event.event,
          .time = Instant{event.time} + shift,
          .text = event.text,
          .place = {event.placeKnown, event.block, event.offset},
          .info = event.info,
          .stamp = event.stamp};
}

RetentiveRanges Cpu::retentiveRanges() const {
  return {std::min(parameters_.retentiveFlags, machine_.areas.flagBytes),
          std::min<std::size_t>(parameters_.retentiveTimers, machine_.timers.size()),
          std::min<std::size_t>(parameters_.retentiveCounters, machine_.counters.size())};
}

void Cpu::retentive(RetentiveData& data) const { keep(data, retentiveRanges(), false); }

void Cpu::keep(RetentiveData& data, const RetentiveRanges& ranges, bool allBlocks) const {
  const Duration standing = machine_.clock - timerTime();  // timers stand still in STOP
  data.now = machine_.clock.ns;
  data.clock = clock_.milliseconds(machine_.clock);
  data.running = mode_ != Mode::Stop || (!powered_ && runningAtPowerOff_);
  data.meters.clear();
  for (const RuntimeMeter& meter : runtimeMeters_)
    data.meters.push_back({meter.counted, meter.since.ns, meter.running});
  const std::uint8_t* flags = machine_.areas.image.data() + machine_.areas.flagBase;
  data.flags.assign(flags, flags + ranges.flags);
  data.timers.resize(ranges.timers);
  for (std::size_t i = 0; i < ranges.timers; ++i)
    data.timers[i] = toRetentive(machine_.timers[i], standing);
  data.counters.resize(ranges.counters);
  for (std::size_t i = 0; i < ranges.counters; ++i)
    data.counters[i] = toRetentive(machine_.counters[i]);
  copyBlocks(machine_.dataBlocks.all(), allBlocks, data.dataBlocks);
  if (data.eventsAdded == diagnostics_.added()) return;
  data.eventsAdded = diagnostics_.added();
  data.events.clear();
  for (const DiagnosticEvent& event : diagnostics_.events())
    data.events.push_back(toRetentive(event));
}

void Cpu::restore(const RetentiveData& data) {
  mode_ = Mode::Stop;
  frozenAt_ = machine_.clock;
  powered_ = false;
  runningAtPowerOff_ = data.running;
  takeBack(data, retentiveRanges(), false);
}

void Cpu::takeBack(const RetentiveData& data, const RetentiveRanges& ranges, bool allBlocks) {
  const Duration shift{machine_.clock.ns - data.now};
  clock_.set(data.clock, machine_.clock);
  for (std::size_t i = 0; i < std::min(runtimeMeters_.size(), data.meters.size()); ++i)
    runtimeMeters_[i] = toMeter(data.meters[i], data);
  std::copy_n(data.flags.begin(), std::min<std::size_t>(ranges.flags, data.flags.size()),
              machine_.areas.image.begin() + machine_.areas.flagBase);
  for (std::size_t i = 0; i < std::min(ranges.timers, data.timers.size()); ++i)
    machine_.timers[i] = toTimer(data.timers[i], shift);
  for (std::size_t i = 0; i < std::min(ranges.counters, data.counters.size()); ++i)
    machine_.counters[i] = toCounter(data.counters[i]);
  for (const RetentiveDataBlock& block : data.dataBlocks)
    restoreBlock(block, allBlocks, machine_.dataBlocks);
  for (const RetentiveEvent& event : data.events) diagnostics_.add(toEvent(event, shift));
}

}  // namespace merker::cpu
