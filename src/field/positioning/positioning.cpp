#include "positioning/positioning.h"

#include <algorithm>

#include "positioning/error.h"

namespace merker::positioning {
namespace {

// Channels of the sub-modules 2.2 and 2.3 (POS-WIRE-01, -02, -05 to -08).
constexpr std::uint32_t kEncoder = 0, kLength = 3, kReference = 4, kInputs = 5;
constexpr std::uint32_t kEnable = 6, kDirection = 7, kFirstContactor = 8, kContactors = 4;
constexpr std::uint32_t kSetPoint = 0;
// Those that are reported as gone by themselves, and those that wait for ERR_A (POS-DIAG-11, -12).
constexpr std::uint16_t kGoing = kMissingPulse | kMovement | kTargetApproach | kTargetRange;

// Which errors cause an interrupt: the monitor and its switch are on (POS-PARAM-27).
std::uint16_t releasedErrors(const io::AxisChannel& axis) {
  const io::AxisMonitors &on = axis.monitors, &wanted = axis.interrupts;
  unsigned errors = 0;
  if (on.missingPulse && wanted.missingPulse) errors |= kMissingPulse;
  if (on.travel && wanted.travel) errors |= kTravelRange;
  if (on.workingRange && wanted.workingRange) errors |= kWorkingRange;
  if (on.movement && wanted.movement) errors |= kMovement;
  if (on.approach && wanted.approach) errors |= kTargetApproach;
  if (on.targetRange && wanted.targetRange) errors |= kTargetRange;
  return static_cast<std::uint16_t>(errors);
}

Channel blank(io::AxisOutput output) {
  Channel channel(io::AxisChannel{.output = output});
  channel.parametrise(false);
  return channel;
}

}  // namespace

Positioning::Axis::Axis(const io::AxisChannel& parameters)
    : channel(parameters),
      encoder(parameters.maxFrequency),
      length(filterTime(parameters.accompanyingFrequency)),
      reference(filterTime(parameters.accompanyingFrequency)) {}

Positioning::Positioning(io::Rack& rack)
    : rack_(rack), blank_{blank(io::AxisOutput::Analog), blank(io::AxisOutput::Digital)} {
  const auto module = rack.module("2.5"), digital = rack.module("2.2");
  if (!module || !digital) return;
  module_ = *module;
  digital_ = *digital;
  analog_ = rack.module("2.3").value_or(0);
  self_ = &rack.configuration().modules[module_];
  if (self_->type->kind != ModuleKind::Positioning || !self_->parameters.axis) return;
  axis_.emplace(*self_->parameters.axis);
  if (self_->parameters.diagnosticInterrupt) released_ = releasedErrors(*self_->parameters.axis);
  for (std::uint32_t i = 0; i < kInputs; ++i) rack_.watch(io::Watcher::Positioning, input(i));
  put();
}

io::Terminal Positioning::input(std::uint32_t channel) const {
  return {digital_, io::Side::DigitalInput, channel};
}
io::Terminal Positioning::output(std::uint32_t channel) const {
  return {digital_, io::Side::DigitalOutput, channel};
}

bool Positioning::answers(std::uint32_t address) const {
  if (self_ == nullptr || self_->type->kind != ModuleKind::Positioning || !self_->inputStart)
    return false;
  return address == std::min(*self_->inputStart, self_->outputStart.value_or(*self_->inputStart));
}

void Positioning::start(Instant now) {
  blocks_.clear();
  if (!axis_) return;
  advance(now);
  inputsTo(now);
  axis_->channel.start();
  put();
  removeErrors(shown_);
}

void Positioning::stop(Instant now) {
  if (!axis_) return;
  advance(now);
  axis_->channel.stop();
  put();
}

void Positioning::advance(Instant now) {
  if (!axis_) return;
  takeEdges();
  runTo(now);
  if (nextCycle_ == now) {
    cycle();
    nextCycle_ = nextCycle_ + kCycle;
  }
}

// An edge at the instant of a cycle lies before it, unless the cycle has been.
void Positioning::takeEdges() {
  for (const io::Edge& edge : rack_.takeEdges(io::Watcher::Positioning)) {
    if (edge.terminal.module != digital_) continue;
    runTo(edge.at);
    inputsTo(edge.at);
    take(edge);
  }
}

void Positioning::take(const io::Edge& edge) {
  switch (edge.terminal.channel) {
    case kLength:
      axis_->length.set(edge.level, edge.signal, edge.at);
      axis_->lengthAt = axis_->channel.position();
      return;
    case kReference:
      return axis_->reference.set(edge.level, edge.signal, edge.at);
    default:
      return axis_->encoder.set(static_cast<EncoderInput::Name>(edge.terminal.channel - kEncoder),
                                edge.level, edge.signal, edge.at, axis_->channel);
  }
}

// All cycles before `to`; what happens at the inputs behind the last one is seen by the next one,
// so that a call sees the state of a cycle (POS-PLANT-18).
void Positioning::runTo(Instant to) {
  for (; nextCycle_ < to; nextCycle_ = nextCycle_ + kCycle) cycle();
}

// In the order of time; at one instant the encoder comes first (POS-PLANT-12).
void Positioning::inputsTo(Instant to) {
  Axis& axis = *axis_;
  for (;;) {
    const Instant length = axis.length.next(), reference = axis.reference.next();
    const Instant at = std::min(length, reference);
    if (at > to) break;
    axis.encoder.advance(at, axis.channel);
    if (length <= reference) {
      const bool waited = axis.length.waiting().has_value();
      if (const auto level = axis.length.take())
        axis.channel.lengthInput(*level, waited ? axis.lengthAt : axis.channel.position());
    } else if (const auto level = axis.reference.take()) {
      axis.channel.referenceSwitch(*level);
    }
  }
  axis.encoder.advance(to, axis.channel);
}

void Positioning::cycle() {
  Channel& channel = axis_->channel;
  channel.parametrise(!rack_.has(module_, io::FaultKind::ParameterError));
  const std::uint16_t before = channel.errors();
  inputsTo(nextCycle_);
  channel.cycle();
  put();
  diagnose(before);
}

void Positioning::put() {
  const io::AxisChannel& parameters = axis_->channel.parameters();
  const Outputs& outputs = axis_->channel.outputs();
  if (parameters.output == io::AxisOutput::Digital) {
    for (std::uint32_t i = 0; i < kContactors; ++i)
      rack_.driveAlways(output(kFirstContactor + i), (outputs.digital >> i & 1) != 0);
    return;
  }
  rack_.driveAlways(output(kEnable), outputs.enable);
  if (parameters.analogControl == io::AnalogControl::WithDirection)
    rack_.driveAlways(output(kDirection), outputs.direction);
  constexpr double kFullScale = 10;  // V
  const double full = static_cast<double>(parameters.highestSpeed) * kThousandths;
  rack_.driveAmount({analog_, io::Side::AnalogOutput, kSetPoint},
                    static_cast<double>(outputs.setPoint) * kFullScale / full,
                    static_cast<std::int16_t>(axis_->channel.analogValue()));
}

// One event for each error that comes; those that go by themselves have done so a cycle later.
void Positioning::diagnose(std::uint16_t before) {
  removeErrors(kGoing);
  callEnded();
  const unsigned fresh = axis_->channel.errors() & ~before & released_;
  for (unsigned bit = 1; bit <= fresh; bit <<= 1) {
    if ((fresh & bit) == 0) continue;
    shown_ = static_cast<std::uint16_t>(shown_ | bit);
    rack_.showAxisErrors(module_, shown_);
  }
}

void Positioning::removeErrors(std::uint16_t gone) {
  shown_ = static_cast<std::uint16_t>(shown_ & ~gone);
  rack_.showAxisErrors(module_, shown_);
}

void Positioning::callEnded() {
  if (axis_) removeErrors(static_cast<std::uint16_t>(~axis_->channel.errors() & ~kGoing));
}

Positioning::Called Positioning::called(io::AxisOutput by, const Instance& instance, Instant now) {
  constexpr std::size_t kMostBlocks = 1024;  // more data blocks than any program has for one axis
  advance(now);
  const BlockKey key{by, instance};
  if (blocks_.size() >= kMostBlocks && !blocks_.contains(key)) blocks_.clear();
  Channel& channel = axis_ ? axis_->channel : blank_[static_cast<std::size_t>(by)];
  return {channel, blocks_.try_emplace(key, by).first->second};
}

}  // namespace merker::positioning
