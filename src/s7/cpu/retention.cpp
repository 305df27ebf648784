#include "cpu/retention.h"

#include <algorithm>

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

void keepEvents(const Diagnostics& buffer, RetentiveData& data) {
  if (data.eventsAdded == buffer.added()) return;
  data.eventsAdded = buffer.added();
  data.events.clear();
  for (const DiagnosticEvent& event : buffer.events())
    data.events.push_back(cpu::toRetentive(event));
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

Retention::Ranges Retention::ranges(Extent extent) const {
  const Ranges all{machine_.areas.flagBytes, machine_.timers.size(), machine_.counters.size()};
  if (extent == Extent::All) return all;
  return {std::min(parameters_.retentiveFlags, all.flags),
          std::min<std::size_t>(parameters_.retentiveTimers, all.timers),
          std::min<std::size_t>(parameters_.retentiveCounters, all.counters)};
}

void Retention::keep(RetentiveData& data, Extent extent, Duration standing) const {
  const Ranges kept = ranges(extent);
  data.now = machine_.clock.ns;
  data.clock = parts_.clock.milliseconds(machine_.clock);
  data.meters.clear();
  for (const RuntimeMeter& meter : parts_.meters)
    data.meters.push_back({meter.counted, meter.since.ns, meter.running});
  const std::uint8_t* flags = machine_.areas.image.data() + machine_.areas.flagBase;
  data.flags.assign(flags, flags + kept.flags);
  data.timers.resize(kept.timers);
  for (std::size_t i = 0; i < kept.timers; ++i)
    data.timers[i] = toRetentive(machine_.timers[i], standing);
  data.counters.resize(kept.counters);
  for (std::size_t i = 0; i < kept.counters; ++i)
    data.counters[i] = toRetentive(machine_.counters[i]);
  copyBlocks(machine_.dataBlocks.all(), extent == Extent::All, data.dataBlocks);
  keepEvents(parts_.log.buffer(), data);
}

void Retention::takeBack(const RetentiveData& data, Extent extent) {
  const Ranges kept = ranges(extent);
  const Duration shift{machine_.clock.ns - data.now};
  parts_.clock.set(data.clock, machine_.clock);
  for (std::size_t i = 0; i < std::min(parts_.meters.size(), data.meters.size()); ++i)
    parts_.meters[i] = toMeter(data.meters[i], data);
  std::copy_n(data.flags.begin(), std::min<std::size_t>(kept.flags, data.flags.size()),
              machine_.areas.image.begin() + machine_.areas.flagBase);
  for (std::size_t i = 0; i < std::min(kept.timers, data.timers.size()); ++i)
    machine_.timers[i] = toTimer(data.timers[i], shift);
  for (std::size_t i = 0; i < std::min(kept.counters, data.counters.size()); ++i)
    machine_.counters[i] = toCounter(data.counters[i]);
  for (const RetentiveDataBlock& block : data.dataBlocks)
    restoreBlock(block, extent == Extent::All, machine_.dataBlocks);
  for (const RetentiveEvent& event : data.events) parts_.log.add(toEvent(event, shift));
}

void Retention::takeMeters(const RetentiveData& data) {
  const Duration shift{machine_.clock.ns - data.now};
  for (std::size_t i = 0; i < std::min(parts_.meters.size(), data.meters.size()); ++i) {
    const block::RetentiveMeter& meter = data.meters[i];
    parts_.meters[i] = {meter.counted, meter.running, Instant{meter.since} + shift};
  }
}

void Retention::clear(Extent extent) {
  const Ranges kept = extent == Extent::All ? Ranges{} : ranges(Extent::Retentive);
  Areas& areas = machine_.areas;
  std::fill(areas.image.begin() + areas.flagBase + kept.flags, areas.image.end(), std::uint8_t{0});
  std::fill(machine_.timers.begin() + static_cast<std::ptrdiff_t>(kept.timers),
            machine_.timers.end(), S5Timer{});
  std::fill(machine_.counters.begin() + static_cast<std::ptrdiff_t>(kept.counters),
            machine_.counters.end(), S5Counter{});
}

}  // namespace merker::cpu
