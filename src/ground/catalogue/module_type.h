// Modules of the S7-300 as constant rows: what a rack can hold (S7-HW-05 to -10). All capabilities
// stand here, none in code.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/cpu_model.h"
#include "catalogue/measuring_range.h"

namespace merker {

enum class ModuleKind : std::uint8_t {
  PowerSupply,    // PS 307
  Interface,      // IM 36x
  Digital,        // SM 321, 322, 323
  Analog,         // SM 331, 332, 334
  Position,       // SM 338
  Function,       // FM 35x: a placeholder with its address space
  Communication,  // CP 34x: the same
  Counting,       // sub-module 2.4 of a compact CPU
  Positioning,    // sub-module 2.5
  PointToPoint    // sub-module 2.1, the serial interface X27
};

struct ModuleType {
  std::string_view orderNumber;  // "6ES7 321-1BH02-0AA0"; empty for on-board sub-modules
  std::string_view name;         // "SM 321"
  std::string_view text;         // "DI16xDC24V"
  ModuleKind kind;
  std::uint8_t digitalInputs = 0, digitalOutputs = 0, analogInputs = 0, analogOutputs = 0;
  std::uint8_t inputBytes = 0, outputBytes = 0;  // address space
  std::uint16_t busCurrent = 0;                  // mA taken from the backplane bus
  std::string_view signal{};                     // "DC 24 V", "AC 120 V"

  // Channels with a hardware interrupt: edges of digital inputs, limits of analog ones.
  std::uint32_t interruptChannels = 0;
  std::uint8_t interruptGroup = 1;  // channels that share their setting of edges
  bool diagnosticInterrupt = false;
  bool substituteValues = false;  // can keep its outputs in STOP or put out substitutes
  // digital inputs, µs
  std::uint32_t inputDelay = 0;                  // default, or fixed
  std::span<const std::uint32_t> inputDelays{};  // that can be set; empty: fixed
  // analog
  std::uint8_t resolution = 0;    // bits
  bool signInResolution = false;  // one of them is the sign in ranges that have one
  std::uint16_t inputRanges = 0, outputRanges = 0;  // RangeSet
  std::uint16_t lastInputRanges = 0;                // of the last input, if not as the others
  std::uint8_t rangeGroup = 1;                      // inputs that share their measuring range
  std::uint32_t conversionTime = 0;                 // µs a channel
  bool wireBreakCheck = false;

  constexpr bool hasInputs() const { return inputBytes > 0; }
  constexpr bool hasOutputs() const { return outputBytes > 0; }
  constexpr bool analogAddresses() const {
    return kind != ModuleKind::Digital;
  }                                      // by default (S7-HW-20, -21)
  constexpr bool signalModule() const {  // SM, FM, CP: slots 4 to 11 (S7-HW-12)
    return kind != ModuleKind::PowerSupply && kind != ModuleKind::Interface;
  }
  constexpr bool placeholder() const {
    return kind == ModuleKind::Function || kind == ModuleKind::Communication;
  }
  // Ranges a channel can be set to.
  std::uint16_t rangesOfInput(unsigned channel) const {
    return channel + 1 == analogInputs && lastInputRanges != 0 ? lastInputRanges : inputRanges;
  }
  unsigned bits(const MeasuringRange& range) const {  // of the resolution, without sign
    return signInResolution && range.low < 0 ? resolution - 1u : resolution;
  }
};

// What a hardware catalogue lists.
std::span<const ModuleType> moduleTypes();
// The sub-modules 2.1 to 2.5 of compact CPUs.
std::span<const ModuleType> onBoardTypes();

// By order number or by name and text ("SM 321 DI16xDC24V"); ignores case, blanks and hyphens.
// Where none fits in full: all rows that begin so.
std::vector<const ModuleType*> findModuleTypes(std::string_view name);
// A sub-module of a compact CPU; null where it has none.
const ModuleType* onBoardType(const CpuModel& model, unsigned subslot);

std::string title(const ModuleType& type);  // "SM 321 DI16xDC24V"

}  // namespace merker
