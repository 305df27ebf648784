// Modules of the S7-300 as constant rows: what a rack can hold (S7-HW-05 to -11). All capabilities
// stand here, none in code.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/cpu_model.h"

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
  Positioning     // sub-module 2.5
};

// Ranges an analog channel can be set to, as bits.
enum RangeSet : std::uint16_t {
  kVolts = 1,         // ±80mV … ±10V, 1..5V
  kCurrents = 2,      // ±3.2mA … ±20mA, 0..20mA, 4..20mA
  kResistances = 4,   // 150Ohm, 300Ohm, 600Ohm
  kThermometers = 8,  // Pt100, Ni100
  kThermocouples = 16,
  kStandard = 32,   // ±10V, 0..10V, ±20mA, 0..20mA, 4..20mA: on board and analog outputs
  kFiveVolts = 64,  // 1..5V of an analog output
  kTenVolts = 128   // only 0..10V (SM 334; 8 bit)
};

struct ModuleType {
  std::string_view orderNumber;  // "6ES7 321-1BH02-0AA0"; empty for on-board sub-modules
  std::string_view name;         // "SM 321"
  std::string_view text;         // "DI16xDC24V"
  ModuleKind kind;
  std::uint8_t digitalInputs = 0, digitalOutputs = 0, analogInputs = 0, analogOutputs = 0;
  std::uint8_t inputBytes = 0, outputBytes = 0;  // address space
  std::uint16_t busCurrent = 0;                  // mA taken from the backplane bus
  std::string_view signal;                       // "DC 24 V", "AC 120 V"

  // digital
  std::uint32_t inputDelay = 0;                // µs, default or fixed
  std::span<const std::uint32_t> inputDelays;  // µs that can be set; empty: fixed
  bool hardwareInterrupt = false;              // edges; analog: limits
  std::uint8_t interruptGroup = 1;             // channels that share their setting of edges
  bool diagnosticInterrupt = false;
  bool substituteValues = false;  // can keep its outputs or put out substitutes
  // analog
  std::uint8_t resolution = 15;                     // bits without sign
  std::uint16_t inputRanges = 0, outputRanges = 0;  // RangeSet
  std::uint16_t conversionTime = 0;                 // µs a channel
  std::uint16_t limitChannels = 0;                  // bit n: channel n has limits
  bool wireBreakCheck = false;

  std::uint16_t suppliedCurrent = 0;  // mA, interface modules: into the bus of their rack

  bool hasInputs() const { return inputBytes > 0; }
  bool hasOutputs() const { return outputBytes > 0; }
  bool analog() const { return kind != ModuleKind::Digital; }  // which default addresses it takes
  bool signalModule() const;                                   // SM, FM, CP: slots 4 to 11
  bool placeholder() const {
    return kind == ModuleKind::Function || kind == ModuleKind::Communication;
  }
};

std::span<const ModuleType> moduleTypes();
// By order number or by name and text ("SM 321 DI16xDC24V"); ignores case, blanks and hyphens.
// Several when only the beginning fits: all rows that begin so.
std::vector<const ModuleType*> findModuleTypes(std::string_view name);

// The sub-modules 2.2 to 2.5 of a compact CPU; null where it has none. Constant rows, one set for
// each kind of compact CPU.
const ModuleType* onBoardType(const CpuModel& model, unsigned subslot);

// "SM 321 DI16xDC24V"
std::string title(const ModuleType& type);

}  // namespace merker
