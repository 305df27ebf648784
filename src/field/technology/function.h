// What a channel does with its signals. Time is an argument; everything happens in its order.
#pragma once

#include <cstdint>
#include <utility>

#include "clock/instant.h"
#include "io/count_channel.h"

namespace merker::technology {

// More pulses than ever come.
constexpr std::uint64_t kUnlimited = std::uint64_t{1} << 62;

class Function {
 public:
  virtual ~Function() = default;

  virtual void start(bool gateLevel, Instant now) = 0;  // STOP to RUN: as parametrised
  virtual void stop() = 0;                              // the CPU went to STOP

  virtual void gateEdge(bool level, Instant at) = 0;
  virtual void latchEdge() {}
  virtual void pulse(int direction, Instant at) = 0;
  // How many pulses of a direction change nothing but the count, and what they are in one step:
  // `last` is the instant of the last one, `before` that of the one before it.
  virtual std::uint64_t absorbs(int direction) const = 0;
  virtual void absorb(int direction, std::uint64_t pulses, Instant last, Instant before) = 0;

  // Its own timer: when, and that it has come.
  virtual Instant due() const { return Instant::never(); }
  virtual void expire(Instant) {}

  // All that it does by itself stands in `due` and at the edges of its inputs; what a call changes
  // it tells by `Counting::changed`. So a cycle whose calls change nothing is the same again.
  virtual bool steady() const { return false; }

  // Whether somebody sees at once what happens: an output, an interrupt.
  virtual bool watched() const = 0;
  virtual bool ownsOutput() const = 0;
  virtual bool output() const = 0;
  virtual std::uint32_t inputData() const = 0;  // four bytes of the periphery (CNT-PIO-02)

  // CountCause since the last call.
  std::uint8_t takeCauses() { return std::exchange(causes_, std::uint8_t{0}); }

 protected:
  void raise(bool enabled, io::CountCause cause) {
    if (enabled) causes_ = static_cast<std::uint8_t>(causes_ | cause);
  }

 private:
  std::uint8_t causes_ = 0;
};

// Software gate, hardware gate and what they make together (CNT-GATE-03).
struct Gate {
  bool used = false;  // the hardware gate
  bool software = false, hardware = false;
  bool closed = false;  // by single counting
  bool open() const { return software && (hardware || !used) && !closed; }
};

// Tells rising edges of what a block gets from call to call.
struct EdgeMemory {
  bool last = false;
  bool rises(bool now) {
    const bool before = std::exchange(last, now);
    return now && !before;
  }
};

}  // namespace merker::technology
