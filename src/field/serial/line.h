// A line with its stations: four wires (RS 422: the first station to all others, these to it) or
// two (RS 485: all at one pair). Time goes from event to event; an idle line has none.
#pragma once

#include <array>
#include <deque>

#include "serial/port.h"

namespace merker::serial {

class Line {
 public:
  explicit Line(bool twoWire = false) : twoWire_(twoWire) {}

  // The driver must outlive the line. Its number: 0 is the first, the master.
  std::size_t join(Driver& driver, const Settings& settings);
  Port& port(std::size_t number) { return ports_[number]; }

  // A cut or swapped pair at the receiver of a port, noise on the pair that it listens to.
  void cut(std::size_t port, bool open, Instant now);
  void swapPolarity(std::size_t port, bool swapped, Instant now);
  void noise(std::size_t port, std::uint16_t bits, std::uint8_t count, std::uint32_t baud,
             Instant at);

  Instant next() const;
  // Everything until and at `to`; also after a job was given to a driver.
  void advance(Instant to);

 private:
  Wire& heardBy(std::size_t port) { return wires_[twoWire_ || port > 0 ? 0 : 1]; }
  Wire& drivenBy(std::size_t port) { return wires_[twoWire_ || port == 0 ? 0 : 1]; }
  void observe(Instant now);

  bool twoWire_;
  std::array<Wire, 2> wires_;
  std::deque<Port> ports_;
};

}  // namespace merker::serial
