#include "technology/counting.h"

#include <algorithm>
#include <utility>

#include "clock/standstill.h"

namespace merker::technology {
namespace {

// A channel's causes in OB40_POINT_ADDR: its half byte in the bytes 8 and 9, and the count edge in
// the bytes 10 and 11 (CNT-PRAL-03, -04).
std::uint32_t pointsOf(std::uint32_t channel, std::uint8_t causes) {
  constexpr unsigned kHalfByte[] = {24, 28, 16, 20}, kEdge[] = {8, 12, 0, 4};
  std::uint32_t points = static_cast<std::uint32_t>(causes & 0xF) << kHalfByte[channel];
  if ((causes & io::kCountEdge) != 0) points |= 1u << kEdge[channel];
  return points;
}

}  // namespace

Counting::Counting(io::Rack& rack) : rack_(rack) {
  const io::Configuration& configuration = rack.configuration();
  const CountingType* type = countingType(*configuration.model);
  const auto module = rack.module("2.4"), digital = rack.module("2.2");
  if (type == nullptr || !module || !digital) return;
  module_ = *module;
  digital_ = *digital;
  self_ = &configuration.modules[module_];
  channels_.resize(type->channels.size());
  for (std::uint32_t i = 0; i < channels_.size(); ++i) {
    const io::CountChannel& parameters = self_->parameters.counters[i];
    channels_[i] = Channel(parameters, type->frequencies.front());
    if (parameters.mode != io::CountMode::None) connect(i, type->channels[i]);
  }
}

void Counting::connect(std::uint32_t channel, const CountingPins& pins) {
  wires_[pins.gate.channel] = {channel, Channel::GateInput};
  wires_[pins.latch.channel] = {channel, Channel::LatchInput};
  wires_[pins.b.channel] = {channel, Channel::TrackB};
  wires_[pins.a.channel] = {channel, Channel::TrackA};
  for (const CountingPin& pin : {pins.gate, pins.latch, pins.b, pins.a})
    rack_.watch(io::Watcher::Counting, {digital_, io::Side::DigitalInput, pin.channel});
  outputs_[channel] = {digital_, io::Side::DigitalOutput, pins.output.channel};
  if (channels_[channel].function()->ownsOutput()) rack_.drive(outputs_[channel], false);
}

bool Counting::sound() const {
  return !rack_.has(module_, io::FaultKind::ParameterError) && rack_.present(module_);
}

bool Counting::inUse() const {
  return std::ranges::any_of(channels_,
                             [](const Channel& one) { return one.function() != nullptr; });
}

bool Counting::steady() const {
  return std::ranges::all_of(channels_, [](const Channel& one) {
    return one.function() == nullptr || one.function()->steady();
  });
}

bool Counting::answers(std::uint32_t address) const {
  return self_ != nullptr && self_->inputStart &&
         address == std::min(*self_->inputStart, self_->outputStart.value_or(*self_->inputStart));
}

Channel& Counting::at(std::uint32_t channel, Instant now) {
  advance(now);
  return channels_[channel];
}

void Counting::start(Instant now) {
  if (self_ == nullptr) return;
  advance(now);
  for (Channel& channel : channels_) channel.start(now);
  jobs_ = {};
  inService_ = waiting_ = 0;
  setLost(false);
  changed_ = true;
}

void Counting::stop() {
  if (self_ == nullptr) return;
  for (Channel& channel : channels_) channel.stop();
  changed_ = true;
}

Instant Counting::next() const {
  if (changed_) return Instant{};
  Instant next = Instant::never();
  for (const Channel& channel : channels_) next = std::min(next, channel.next());
  return next;
}

Instant Counting::nextVisible() const {
  Instant next = this->next();
  for (const Channel& channel : channels_) next = std::min(next, channel.nextVisible());
  return next;
}

// What falls on one instant is one interrupt, so the events go by in their order (CNT-PRAL-11).
void Counting::advance(Instant now) {
  if (self_ == nullptr) return;
  if (inUse()) {
    takeEdges();
    advanceChannels(now);
    show();
  }
  changed_ = false;
}

void Counting::advanceChannels(Instant now) {
  Standstill loop;
  for (Instant next = this->next(); next <= now && loop.moves(next); next = this->next()) {
    changed_ = false;
    for (Channel& channel : channels_) channel.advance(next);
    collect();
  }
  for (Channel& channel : channels_) channel.advance(now);
  collect();
}

void Counting::takeEdges() {
  for (const io::Edge& edge : rack_.takeEdges(io::Watcher::Counting)) {
    const auto& wire = wires_[edge.terminal.channel];
    if (edge.terminal.module != digital_ || !wire) continue;
    changed_ = false;
    advanceChannels(edge.at);
    channels_[wire->channel].set(wire->input, edge.level, edge.signal, edge.at);
  }
}

void Counting::collect() {
  std::uint32_t points = 0;
  for (std::uint32_t i = 0; i < channels_.size(); ++i)
    if (Function* function = channels_[i].function()) points |= pointsOf(i, function->takeCauses());
  if (points != 0 && self_->parameters.hardwareInterrupt) raise(points);
}

// One interrupt at a time. Further causes wait; one that is there already is lost (CNT-DIAG-05,
// CNT-PRAL-12).
void Counting::raise(std::uint32_t points) {
  if (inService_ == 0) return tell(points);
  const bool lost = (points & (inService_ | waiting_)) != 0;
  waiting_ |= points & ~inService_;
  if (lost) setLost(true);
}

void Counting::tell(std::uint32_t points) {
  inService_ = points;
  rack_.interrupt(module_, points);
}

void Counting::acknowledged(std::uint32_t address) {
  if (self_ == nullptr || !self_->inputStart || address != *self_->inputStart || inService_ == 0)
    return;
  const std::uint32_t points = std::exchange(waiting_, 0);
  inService_ = 0;
  if (points != 0)
    tell(points);
  else
    setLost(false);
}

void Counting::setLost(bool lost) {
  rack_.fault(module_, io::FaultKind::InterruptLost, std::nullopt, lost);
}

void Counting::show() {
  for (std::uint32_t i = 0; i < channels_.size(); ++i) {
    const Function* function = channels_[i].function();
    if (function == nullptr) continue;
    if (function->ownsOutput()) rack_.drive(outputs_[i], function->output());
    rack_.show(module_, i, function->inputData());
  }
}

}  // namespace merker::technology
