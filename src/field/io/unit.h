// One module in operation: what lies at its terminals, what it delivers, what is wrong with it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/analog_inputs.h"
#include "io/digital_inputs.h"
#include "io/module_faults.h"

namespace merker::io {

// Digital outputs that a channel of `technology` or `positioning` drives in place of the CPU.
class DrivenOutputs {
 public:
  // `always`: also while the CPU disables its outputs (POS-END-08).
  void drive(std::uint32_t channel, bool level, bool always = false) {
    const std::uint32_t bit = 1u << channel;
    driven_ |= bit;
    levels_ = level ? levels_ | bit : levels_ & ~bit;
    if (always) always_ |= bit;
  }
  // Nothing: the output is the CPU's.
  std::optional<bool> level(std::uint32_t channel) const {
    if ((driven_ >> channel & 1) == 0) return std::nullopt;
    return (levels_ >> channel & 1) != 0;
  }
  bool always(std::uint32_t channel) const { return (always_ >> channel & 1) != 0; }

 private:
  std::uint32_t driven_ = 0, levels_ = 0, always_ = 0;
};

// The analog output that an axis drives; its voltage has no steps (POS-PLANT-07).
struct DrivenAmount {
  std::uint32_t channel = 0;
  double volts = 0;
  std::int16_t word = 0;  // as the CPU would have to write it
};

struct Unit {
  DigitalInputs digital;
  AnalogInputs analog;
  DrivenOutputs driven;
  std::optional<DrivenAmount> amount;
  std::vector<std::uint8_t> answer;  // of a drive behind a slave: its telegram to the master
  ModuleFaults faults;
  std::vector<std::uint8_t> diagnosis;  // data record 1, as last reported

  bool faulty() const { return (diagnosis[0] & 1) != 0; }
};

}  // namespace merker::io
