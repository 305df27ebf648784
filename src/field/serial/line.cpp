#include "serial/line.h"

#include <algorithm>

#include "clock/standstill.h"

namespace merker::serial {

std::size_t Line::join(Driver& driver, const Settings& settings) {
  const std::size_t number = ports_.size();
  ports_.emplace_back(number, driver, settings, drivenBy(number), heardBy(number));
  return number;
}

// Receivers sample what was, before something changes; nobody needs older characters then.
void Line::observe(Instant now) {
  std::array<Instant, 2> needed{Instant::never(), Instant::never()};
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Receiver& receiver = ports_[i].receiver();
    receiver.observe(now);
    Instant& mine = needed[&heardBy(i) == wires_.data() ? 0 : 1];
    mine = std::min(mine, receiver.needs());
  }
  for (std::size_t i = 0; i < wires_.size(); ++i)
    wires_[i].forget(needed[i] == Instant::never() ? now : needed[i]);
}

void Line::cut(std::size_t port, bool open, Instant now) {
  advance(now);
  observe(now);
  ports_[port].receiver().cut(open);
}

void Line::swapPolarity(std::size_t port, bool swapped, Instant now) {
  advance(now);
  observe(now);
  ports_[port].receiver().swapPolarity(swapped);
}

void Line::noise(std::size_t port, std::uint16_t bits, std::uint8_t count, std::uint32_t baud,
                 Instant at) {
  heardBy(port).put({.start = at, .baud = baud, .bits = bits, .count = count, .noise = true});
}

Instant Line::next() const {
  Instant first = Instant::never();
  for (const Port& port : ports_) first = std::min(first, port.next());
  return first;
}

// At one instant: what has left, what has arrived, timers, what is sent next. Where nothing happens
// nobody samples: what begins at `to` does not change what was before.
void Line::advance(Instant to) {
  Standstill standstill;
  for (Instant now = next(); now <= to && standstill.moves(now); now = next()) {
    for (Port& port : ports_) port.finish(now);
    for (Port& port : ports_) port.receive(now);
    observe(now);
    for (Port& port : ports_) port.run(now);
  }
  for (Port& port : ports_) port.run(to);
}

}  // namespace merker::serial
