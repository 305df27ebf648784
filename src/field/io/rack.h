// The modules in operation, between terminals and the periphery bytes of the CPU. A value; time is
// an argument. Terminals have levels and amounts, the CPU sees bytes: input delay, conversion,
// interrupts, faults and substitute values lie in between.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/event_list.h"
#include "io/periphery_bytes.h"
#include "io/process_data.h"
#include "io/terminal.h"
#include "io/unit.h"
#include "io/watched_edges.h"

namespace merker::io {

class Rack {
 public:
  explicit Rack(Configuration configuration);

  const Configuration& configuration() const { return configuration_; }
  // "4", "Conveyor", "2.2"; none if there is no such module, or no such channel.
  std::optional<std::uint32_t> module(std::string_view name) const;
  std::optional<Terminal> terminal(std::string_view module, Side side, std::uint32_t channel) const;

  // Terminals: a level (24 V or 0 V) or an amount in V, mA, Ohm or degC by the channel's range.
  // Plants set inputs and read outputs; both can be read.
  void setLevel(Terminal terminal, bool level, Instant now);
  bool level(Terminal terminal) const;
  // A signal that changes by itself; a level that is set later takes its place.
  void attach(Terminal terminal, std::shared_ptr<const signal::Signal> signal, Instant now);
  bool hasSignals() const { return signals_ > 0; }
  // Brings inputs with such signals to `now`: their edges are not followed unless they interrupt.
  void settle(Instant now);
  void setAmount(Terminal terminal, double amount, Instant now);
  double amount(Terminal terminal) const;
  const MeasuringRange* range(Terminal terminal) const;  // null: digital or deactivated

  // What a module delivers from now on, past terminal and delay: `set E 124.0 = 1`
  // (docs/compatibility.md). Edges interrupt as ever. False if no input module lies there.
  bool deliver(std::uint32_t byte, std::uint8_t mask, std::uint8_t value, Instant now);

  // A fault comes or goes; `channel` only for kinds that have one, none = all channels. False if
  // this module cannot have it.
  bool fault(std::uint32_t module, FaultKind kind, std::optional<std::uint32_t> channel,
             bool there);
  bool faulty(std::uint32_t module) const;  // any: its SF lamp
  bool has(std::uint32_t module, FaultKind kind) const { return units_[module].faults.has(kind); }
  // Of the module, or of any channel.
  bool hasAnywhere(std::uint32_t module, FaultKind kind) const {
    return units_[module].faults.hasAnywhere(kind);
  }
  // Plugged, its rack supplied, and a slave reached by its master.
  bool present(std::uint32_t module) const { return present_[module] != 0; }

  // For channels of `technology` and `positioning`, beside the input delay and the output bytes:
  // fast inputs, outputs that a channel drives, four bytes of input data each, interrupts.
  void watch(Watcher who, Terminal input) { edges_.watch(who, input); }
  std::vector<Edge> takeEdges(Watcher who) { return edges_.take(who); }
  void drive(Terminal output, bool level) {
    units_[output.module].driven.drive(output.channel, level);
  }
  // By an axis, which stops by itself when the CPU does.
  void driveAlways(Terminal output, bool level) {
    units_[output.module].driven.drive(output.channel, level, true);
  }
  void driveAmount(Terminal output, double volts, std::int16_t word) {
    units_[output.module].amount = {output.channel, volts, word};
  }
  // The errors that the diagnostic data of an axis show, bytes 8 and 9 of data record 1: one event
  // for each that comes, one when the last has gone (POS-DIAG-03, -16).
  void showAxisErrors(std::uint32_t module, std::uint16_t errors);
  void show(std::uint32_t module, std::uint32_t channel, std::uint32_t data);
  void interrupt(std::uint32_t module, std::uint32_t points);

  // For a drive behind a DP slave: whether its master's data are good, the setpoints as the last
  // turn on the bus left them, and what it answers.
  bool exchanging(std::uint32_t module) const;
  std::int32_t received(const ProcessData& data) const;
  void answer(const ProcessData& data, std::int32_t value);
  // The same for areas that two stations exchange: all bytes, and an output of this one.
  void answer(std::uint32_t module, std::vector<std::uint8_t> bytes);
  std::uint8_t sent(std::uint32_t byte) const {
    return outputs_.supplied() && !outputs_.disabled() ? outputs_.byte(byte) : std::uint8_t{0};
  }
  // The line is whole from the master to this head of a slave.
  bool lineReaches(std::uint32_t head) const;
  // The CPU behind this head goes to STOP, or leaves it: a diagnostic interrupt.
  void partnerStops(std::uint32_t head, bool stops);

  // time: nothing moves outside these calls
  Instant next() const { return next_; }  // when an input delay or a conversion ends
  // The same without conversions that only an access sees.
  Instant nextVisible() const { return nextVisible_; }
  void advance(Instant now);

  // Whether there is something to tell the CPU: bytes, presence, events.
  bool pending() const { return inputs_.changed() || events_.any() || edges_.any(); }
  // Beside what only an access sees.
  bool pendingVisibly() const {
    return inputs_.changedBefore(imageBytes()) || events_.any() || edges_.any();
  }
  // What the inputs of this module convert is seen by nothing but L PEW: they lie behind the
  // process image and interrupt nobody.
  bool onlyByAccess(std::uint32_t module) const;

  // towards the CPU
  const std::vector<std::uint8_t>& inputs() const { return inputs_.all(); }  // what PE shows
  bool answersInput(std::uint32_t byte) const { return answers(inputs_.owner(byte)); }
  bool answersOutput(std::uint32_t byte) const;
  void written(std::uint32_t first, const std::uint8_t* bytes, std::uint32_t count) {
    outputs_.write(first, bytes, count);
  }
  void disableOutputs(bool disabled) { outputs_.disable(disabled); }
  // The supply of the station: without it no module puts out anything, whatever its parameters say.
  void supply(bool on) { outputs_.supply(on); }
  // The start has given the modules their parameters: faults that are there are reported (again).
  void reportFaults();
  // What a module puts out at this address, as the CPU would have to write it.
  std::uint8_t putOut(std::uint32_t byte) const;
  // Inputs that changed since the last call, and whether a module came or went.
  Bytes takeChanged() { return inputs_.takeChanged(); }
  bool takePresenceChanged() { return events_.takePresenceChanged(); }
  std::vector<ModuleEvent> takeEvents() { return events_.take(); }  // since the last call, in order

  // The module at a logical address, null if none is there; its data records 0 and 1: diagnostic
  // data (S7-SFC: 13, 51, 59).
  const Module* at(std::uint32_t address, bool output) const;
  std::vector<std::uint8_t> record0(const Module& module) const;
  std::vector<std::uint8_t> record1(const Module& module) const;

 private:
  const Module& of(std::uint32_t index) const { return configuration_.modules[index]; }
  std::uint32_t imageBytes() const { return configuration_.model->imageBytes; }
  std::uint32_t index(const Module& module) const;
  bool answers(std::optional<std::uint32_t> owner) const { return owner && present(*owner); }
  // inputs.cpp
  void change(Terminal terminal, bool level, Instant now);
  void detach(Terminal terminal, Instant now);
  void take(std::uint32_t index, std::uint32_t levels);  // inputs pass the delay
  void showBits(std::uint32_t index);
  void showAnswer(std::uint32_t index);  // process_data.cpp
  // asi.cpp
  void showAsi(std::uint32_t index, std::uint32_t bits);
  bool asiOutput(const Module& slave, std::uint32_t channel) const;
  std::uint32_t missingOnAsi(std::uint32_t cp) const;
  void asiFault(std::uint32_t index, FaultKind kind, bool there);
  bool convert(std::uint32_t index, std::uint32_t channel);  // whether its faults are others now
  // outputs.cpp
  bool outputLevel(std::uint32_t index, std::uint32_t channel) const;
  double outputAmount(std::uint32_t index, std::uint32_t channel) const;
  std::uint8_t putOutBits(std::uint32_t index, std::uint32_t offset) const;
  // faults.cpp
  std::vector<std::uint8_t> diagnosisOf(std::uint32_t index) const;
  void reportDiagnosis(std::uint32_t index);
  void diagnose(std::uint32_t index);
  void presence(std::uint32_t index, ModuleEvent::Kind kind);
  void presenceFault(std::uint32_t index, FaultKind kind, bool there);
  std::vector<char> presentNow() const;
  void refresh(std::uint32_t index);  // after a fault came or went
  // rack.cpp
  void advance(std::uint32_t index, Instant at);
  void findNext();

  Configuration configuration_;
  std::vector<Unit> units_;    // by module
  std::vector<char> present_;  // by module
  InputBytes inputs_;
  OutputBytes outputs_;
  EventList events_;
  WatchedEdges edges_;
  Instant next_ = Instant::never(), nextVisible_ = Instant::never();
  std::size_t signals_ = 0;  // that lie at terminals
};

}  // namespace merker::io
