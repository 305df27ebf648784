// Terminals with signals that are known in advance, and what channels of `technology` need of the
// rack.
#include <algorithm>

#include "base/bytes.h"
#include "io/rack.h"

namespace merker::io {
namespace {

// The level that last lasted for the delay, looking back from `now`; `otherwise` if none did since
// the signal lies there.
bool settledLevel(const Unit::Attached& attached, Duration delay, Instant now, bool otherwise) {
  constexpr int kMost = 64;  // signals without rhythm: enough
  const signal::Signal& signal = *attached.signal;
  Instant end = now, at = now;
  for (int i = 0; i < kMost; ++i) {
    const Instant begin = std::max(signal.last(at), attached.since);
    if (end - begin >= delay) return signal.level(begin);
    if (begin == attached.since) return otherwise;
    end = begin;
    at = begin - Duration{1};
  }
  return otherwise;
}

}  // namespace

void Rack::attach(Terminal terminal, std::shared_ptr<const signal::Signal> signal, Instant now) {
  if (terminal.side != Side::DigitalInput) return;
  detach(terminal, now);
  Unit& unit = units_[terminal.module];
  const bool level = signal->level(now);
  noteEdge(terminal, level, now, signal);
  change(terminal, level, now);
  unit.signals[terminal.channel] = {std::move(signal), now, now};
  ++signals_;
  findNext();
}

void Rack::detach(Terminal terminal, Instant now) {
  Unit& unit = units_[terminal.module];
  const auto found = unit.signals.find(terminal.channel);
  if (found == unit.signals.end()) return;
  settle(now);
  unit.signals.erase(found);
  --signals_;
  noteEdge(terminal, level(terminal), now, nullptr);
  findNext();
}

// Only where each edge may be an interrupt.
bool Rack::follows(std::uint32_t index, std::uint32_t channel) const {
  const Parameters& parameters = of(index).parameters;
  return ((parameters.risingEdges | parameters.fallingEdges) >> channel & 1) != 0;
}

Instant Rack::nextChange(std::uint32_t index) const {
  Instant next = Instant::never();
  for (const auto& [channel, attached] : units_[index].signals)
    if (follows(index, channel)) next = std::min(next, attached.signal->next(attached.seen));
  return next;
}

void Rack::follow(std::uint32_t index, Instant now) {
  for (auto& [channel, attached] : units_[index].signals) {
    if (!follows(index, channel)) continue;
    attached.seen = now;
    change({index, Side::DigitalInput, channel}, attached.signal->level(now), now);
  }
}

void Rack::settle(Instant now) {
  if (signals_ == 0) return;
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    Unit& unit = units_[i];
    std::uint32_t delivered = unit.delivered;
    for (auto& [channel, attached] : unit.signals) {
      if (follows(i, channel)) continue;
      const std::uint32_t bit = 1u << channel;
      const bool passed =
          settledLevel(attached, of(i).parameters.inputDelay, now, (unit.delivered & bit) != 0);
      delivered = passed ? delivered | bit : delivered & ~bit;
      unit.levels = attached.signal->level(now) ? unit.levels | bit : unit.levels & ~bit;
      unit.levelDue[channel] = Instant::never();
    }
    if (delivered != unit.delivered) take(i, delivered);
  }
}

void Rack::watch(Terminal input) { units_[input.module].watched |= 1u << input.channel; }

void Rack::drive(Terminal output, bool level) {
  Unit& unit = units_[output.module];
  const std::uint32_t bit = 1u << output.channel;
  unit.driven |= bit;
  unit.drivenLevels = level ? unit.drivenLevels | bit : unit.drivenLevels & ~bit;
}

void Rack::show(std::uint32_t module, std::uint32_t channel, std::uint32_t data) {
  std::uint8_t bytes[4];
  storeDWord(bytes, present(module) ? data : 0);
  for (std::uint32_t i = 0; i < 4; ++i)
    setInput(*of(module).inputStart + 4 * channel + i, bytes[i]);
}

}  // namespace merker::io
