// The sub-module 2.5 "Positioning" of a compact CPU: its channel between the terminals of the
// sub-modules 2.2 and 2.3 and the CPU (technology manual 3.1.3, 4.1.3; POS-WIRE).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "io/rack.h"
#include "positioning/block.h"
#include "positioning/encoder_input.h"
#include "positioning/switch_input.h"

namespace merker::positioning {

class Positioning {
 public:
  // The rack must outlive it. Without an axis in the configuration it does nothing.
  explicit Positioning(io::Rack& rack);

  void start(Instant now);  // STOP to RUN (POS-RUN-33)
  void stop(Instant now);   // to STOP or HALT, or without supply (POS-END-08)
  Instant next() const { return axis_ ? nextCycle_ : Instant::never(); }
  // Cycles and what happens at the inputs until then; a cycle at `now` is the last one.
  void advance(Instant now);

  // For the system functions.
  bool answers(std::uint32_t address) const;
  // The instance data block of a call, and where in it the data of the SFB begin.
  struct Instance {
    std::uint16_t block = 0;
    std::uint32_t offset = 0;
    auto operator<=>(const Instance&) const = default;
  };
  struct Called {
    Channel& channel;
    Block& block;
  };
  // At `now`. Without an axis the channel is not parametrised, whichever block asks.
  Called called(io::AxisOutput by, const Instance& instance, Instant now);
  void callEnded();  // errors may be acknowledged

  // As seen from outside; null without an axis.
  const Channel* channel() const { return axis_ ? &axis_->channel : nullptr; }

 private:
  struct Axis {
    explicit Axis(const io::AxisChannel& parameters);
    Channel channel;
    EncoderInput encoder;
    SwitchInput length, reference;
    std::int64_t lengthAt = 0;  // position at the edge that waits
  };
  using BlockKey = std::pair<io::AxisOutput, Instance>;

  io::Terminal input(std::uint32_t channel) const;
  io::Terminal output(std::uint32_t channel) const;
  void takeEdges();
  void take(const io::Edge& edge);
  void runTo(Instant to);
  void inputsTo(Instant to);
  void cycle();
  void put();
  void diagnose(std::uint16_t before);
  void removeErrors(std::uint16_t gone);

  io::Rack& rack_;
  const io::Module* self_ = nullptr;  // null: there is no such sub-module
  std::uint32_t module_ = 0, digital_ = 0, analog_ = 0;
  std::optional<Axis> axis_;
  std::array<Channel, 2> blank_;  // by AxisOutput, if there is no axis
  std::map<BlockKey, Block> blocks_;
  Instant nextCycle_{};
  std::uint16_t released_ = 0, shown_ = 0;  // errors with an interrupt, and those in record 1
};

}  // namespace merker::positioning
