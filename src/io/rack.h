// The modules in operation, between terminals and the periphery bytes of the CPU. A value; time is
// an argument. Terminals have levels and amounts, the CPU sees bytes: input delay, conversion,
// interrupts, faults and substitute values lie in between.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/module_event.h"
#include "clock/instant.h"
#include "io/configuration.h"
#include "io/fault.h"

namespace merker::io {

// A signal connection: channel of a module, counted from 0 separately for digital inputs, digital
// outputs, analog inputs and analog outputs.
enum class Side : std::uint8_t { DigitalInput, DigitalOutput, AnalogInput, AnalogOutput };
struct Terminal {
  std::uint32_t module = 0;  // index in Configuration::modules
  Side side = Side::DigitalInput;
  std::uint32_t channel = 0;
  bool operator==(const Terminal&) const = default;
};

// Bytes of the periphery that changed.
struct Change {
  std::uint32_t first = 0;
  std::vector<std::uint8_t> bytes;
};

class Rack {
 public:
  explicit Rack(Configuration configuration);

  const Configuration& configuration() const { return configuration_; }

  // The terminal of this module ("4", "Conveyor") and channel; none if there is no such.
  std::optional<Terminal> terminal(std::string_view module, Side side, std::uint32_t channel) const;

  // Terminals: a level (24 V or 0 V) or an amount in V, mA, Ohm or degC by the channel's range.
  // Plants set inputs and read outputs; both can be read.
  void setLevel(Terminal terminal, bool level, Instant now);
  bool level(Terminal terminal) const;
  void setAmount(Terminal terminal, double amount, Instant now);
  double amount(Terminal terminal) const;

  // What a module delivers from now on, past terminal and delay: `set E 124.0 = 1`
  // (docs/compatibility.md). Edges interrupt as ever. False if no input module lies there.
  bool deliver(std::uint32_t byte, std::uint8_t mask, std::uint8_t value, Instant now);

  // A fault comes or goes; `channel` only for kinds that have one, none = all channels. False if
  // this module cannot have it.
  bool fault(std::uint32_t module, FaultKind kind, std::optional<std::uint32_t> channel, bool there,
             Instant now);
  bool faulty(std::uint32_t module) const;  // any: its SF lamp

  // time: nothing moves outside these calls
  Instant next() const;  // when an input delay or a conversion ends next
  void advance(Instant now);

  // towards the CPU
  const std::vector<std::uint8_t>& inputs() const { return inputs_; }  // the bytes PE shows
  bool inputPresent(std::uint32_t byte) const;  // a module that is there answers
  bool outputPresent(std::uint32_t byte) const;
  void written(std::uint32_t first, const std::uint8_t* bytes, std::uint32_t count);
  void disableOutputs(bool disabled);
  // Counts changes of inputs() and of what is present: whoever copies them looks here first.
  std::uint64_t revision() const { return revision_; }
  std::vector<ModuleEvent> takeEvents();  // those since the last call, in order

  // Data records of the module at a logical address (S7-SFC-18: SFC 58, 59; S7-SFC 13, 51).
  // 0 and 1: diagnostic data, read only. None if no module is there or it has no such record.
  const Module* at(std::uint32_t address, bool output) const;
  std::optional<std::vector<std::uint8_t>> record(const Module& module, std::uint8_t number) const;

 private:
  struct Unit;
  Configuration configuration_;
  std::vector<std::uint8_t> inputs_, outputs_;
  std::uint64_t revision_ = 0;
};

}  // namespace merker::io
