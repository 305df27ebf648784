// The rows of the modules. Order numbers, channels and currents of the backplane bus: manual
// "S7-300 Module data" (docs/compatibility.md, "Modules").
#include <array>

#include "catalogue/module_type.h"

namespace merker {
namespace {

using Kind = ModuleKind;

constexpr std::array<std::uint32_t, 5> kDelays321{100, 500, 3'000, 15'000, 20'000};
constexpr std::array<std::uint32_t, 4> kDelaysOnBoard{100, 300, 3'000, 15'000};
constexpr std::uint32_t kDirect = 3'000, kAlternating = 15'000;  // µs, fixed delays by the voltage
constexpr std::uint16_t kAllAnalog = kVolts | kStandard | kCurrents | kResistances | kThermometers;

constexpr std::uint8_t bytes(int channels) { return static_cast<std::uint8_t>((channels + 7) / 8); }

constexpr ModuleType other(std::string_view order, std::string_view name, std::string_view text,
                           Kind kind, std::uint16_t current) {
  ModuleType type{.orderNumber = order, .name = name, .text = text, .kind = kind};
  type.busCurrent = current;
  if (type.signalModule()) type.inputBytes = type.outputBytes = 16;
  return type;
}

constexpr ModuleType digital(std::string_view order, std::string_view name, std::string_view text,
                             int inputs, int outputs, std::uint16_t current,
                             std::string_view signal, std::uint32_t delay = 0) {
  ModuleType type{.orderNumber = order, .name = name, .text = text, .kind = Kind::Digital};
  type.digitalInputs = static_cast<std::uint8_t>(inputs);
  type.digitalOutputs = static_cast<std::uint8_t>(outputs);
  type.inputBytes = bytes(inputs);
  type.outputBytes = bytes(outputs);
  type.busCurrent = current;
  type.signal = signal;
  type.inputDelay = delay;
  return type;
}

constexpr ModuleType analog(std::string_view order, std::string_view name, std::string_view text,
                            int inputs, int outputs, std::uint16_t current, std::uint8_t resolution,
                            bool signInside, int inputRanges, int outputRanges,
                            std::uint32_t conversion) {
  ModuleType type{.orderNumber = order, .name = name, .text = text, .kind = Kind::Analog};
  type.analogInputs = static_cast<std::uint8_t>(inputs);
  type.analogOutputs = static_cast<std::uint8_t>(outputs);
  type.inputBytes = static_cast<std::uint8_t>(2 * inputs);
  type.outputBytes = static_cast<std::uint8_t>(2 * outputs);
  type.busCurrent = current;
  type.signal = "DC 24 V";
  type.resolution = resolution;
  type.signInResolution = signInside;
  type.inputRanges = static_cast<std::uint16_t>(inputRanges);
  type.outputRanges = static_cast<std::uint16_t>(outputRanges);
  type.conversionTime = conversion;
  return type;
}

// With diagnostic interrupt and, for inputs, limits on some channels.
constexpr ModuleType diagnosing(ModuleType type, std::uint32_t interrupts = 0) {
  type.diagnosticInterrupt = true;
  type.interruptChannels = interrupts;
  type.wireBreakCheck = type.analogInputs > 0;
  type.substituteValues = type.hasOutputs();
  return type;
}

constexpr ModuleType settable(ModuleType type, std::span<const std::uint32_t> delays,
                              std::uint32_t interrupts, std::uint8_t group) {
  type.inputDelays = delays;
  type.interruptChannels = interrupts;
  type.interruptGroup = group;
  return type;
}

// Measuring method and range are set for two channels at a time.
constexpr ModuleType paired(ModuleType type) {
  type.rangeGroup = 2;
  return type;
}

// Nothing can be written to it; SFB 47 to 49 work on its channels (technology manual 5.4, 5.8.3).
constexpr ModuleType counting() {
  ModuleType type = other("", "", "Count", Kind::Counting, 0);
  type.diagnosticInterrupt = true;
  return type;
}

constexpr ModuleType positioning() {
  ModuleType type = other("", "", "Position", Kind::Positioning, 0);
  type.diagnosticInterrupt = true;
  return type;
}

// An address, but no bytes behind it: SFB 60 to 65 work with it (technology manual 6.4).
constexpr ModuleType pointToPoint() {
  ModuleType type = other("", "", "PtP", Kind::PointToPoint, 0);
  type.inputBytes = 1;
  type.outputBytes = 0;
  type.diagnosticInterrupt = true;
  return type;
}

constexpr ModuleType position() {
  ModuleType type = other("6ES7 338-4BC01-0AB0", "SM 338", "POS-INPUT 3xSSI", Kind::Position, 160);
  type.outputBytes = 0;  // S7-HW-07
  type.signal = "DC 24 V";
  return type;
}

constexpr ModuleType compactAnalog() {
  ModuleType type = analog("", "", "AI5/AO2", 5, 2, 0, 12, true, kStandard, kStandard, 1'000);
  type.lastInputRanges = kOnBoardResistor;
  return type;
}

constexpr std::string_view kDc = "DC 24 V", kAc = "AC 120/230 V";

constexpr std::array kModules{
    other("6ES7 307-1BA01-0AA0", "PS 307", "2A", Kind::PowerSupply, 0),
    other("6ES7 307-1EA01-0AA0", "PS 307", "5A", Kind::PowerSupply, 0),
    other("6ES7 307-1KA02-0AA0", "PS 307", "10A", Kind::PowerSupply, 0),

    other("6ES7 360-3AA01-0AA0", "IM 360", "sender", Kind::Interface, 350),
    other("6ES7 361-3CA01-0AA0", "IM 361", "receiver", Kind::Interface, 0),
    other("6ES7 365-0BA01-0AA0", "IM 365", "pair", Kind::Interface, 100),

    digital("6ES7 321-1BH02-0AA0", "SM 321", "DI16xDC24V", 16, 0, 10, kDc, kDirect),
    digital("6ES7 321-1BL00-0AA0", "SM 321", "DI32xDC24V", 32, 0, 15, kDc, kDirect),
    settable(diagnosing(digital("6ES7 321-7BH01-0AB0", "SM 321", "DI16xDC24V interrupt", 16, 0, 130,
                                kDc, kDirect)),
             kDelays321, 0xFFFF, 2),
    digital("6ES7 321-1EL00-0AA0", "SM 321", "DI32xAC120V", 32, 0, 16, "AC 120 V", kAlternating),
    digital("6ES7 321-1FH00-0AA0", "SM 321", "DI16xAC120/230V", 16, 0, 29, kAc, kAlternating),
    digital("6ES7 321-1FF01-0AA0", "SM 321", "DI8xAC120/230V", 8, 0, 29, kAc, kAlternating),

    digital("6ES7 322-1BH01-0AA0", "SM 322", "DO16xDC24V/0.5A", 0, 16, 80, kDc),
    digital("6ES7 322-1BL00-0AA0", "SM 322", "DO32xDC24V/0.5A", 0, 32, 110, kDc),
    digital("6ES7 322-1BF01-0AA0", "SM 322", "DO8xDC24V/2A", 0, 8, 40, kDc),
    diagnosing(
        digital("6ES7 322-8BF00-0AB0", "SM 322", "DO8xDC24V/0.5A diagnostic", 0, 8, 70, kDc)),
    digital("6ES7 322-1HH01-0AA0", "SM 322", "DO16xrelay", 0, 16, 100, "AC 230 V"),
    digital("6ES7 322-1HF01-0AA0", "SM 322", "DO8xrelay", 0, 8, 40, "AC 230 V"),
    digital("6ES7 322-1FH00-0AA0", "SM 322", "DO16xAC120/230V/1A", 0, 16, 200, kAc),
    digital("6ES7 322-1FF01-0AA0", "SM 322", "DO8xAC120/230V/2A", 0, 8, 100, kAc),

    digital("6ES7 323-1BH01-0AA0", "SM 323", "DI8/DO8xDC24V/0.5A", 8, 8, 40, kDc, kDirect),
    digital("6ES7 323-1BL00-0AA0", "SM 323", "DI16/DO16xDC24V/0.5A", 16, 16, 80, kDc, kDirect),

    paired(diagnosing(
        analog("6ES7 331-7KF02-0AB0", "SM 331", "AI8x12bit", 8, 0, 50, 12, false,
               kVolts | kCurrents | kResistances | kThermometers | kThermocouples, 0, 22'000),
        0x05)),
    paired(diagnosing(
        analog("6ES7 331-7KB02-0AB0", "SM 331", "AI2x12bit", 2, 0, 50, 12, false,
               kVolts | kCurrents | kResistances | kThermometers | kThermocouples, 0, 22'000),
        0x01)),
    analog("6ES7 331-1KF01-0AB0", "SM 331", "AI8x13bit", 8, 0, 90, 12, false, kAllAnalog, 0,
           66'000),
    paired(diagnosing(analog("6ES7 331-7NF00-0AB0", "SM 331", "AI8x16bit", 8, 0, 130, 15, false,
                             kVolts | kCurrents, 0, 23'000),
                      0x05)),
    paired(diagnosing(analog("6ES7 331-7PF01-0AB0", "SM 331", "AI8xRTD", 8, 0, 100, 15, false,
                             kResistances | kThermometers, 0, 50'000),
                      0xFF)),
    paired(diagnosing(analog("6ES7 331-7PF11-0AB0", "SM 331", "AI8xTC", 8, 0, 100, 15, false,
                             kThermocouples, 0, 50'000),
                      0xFF)),

    diagnosing(analog("6ES7 332-5HB01-0AB0", "SM 332", "AO2x12bit", 0, 2, 60, 12, true, 0,
                      kStandard | kFiveVolts, 800)),
    diagnosing(analog("6ES7 332-5HD01-0AB0", "SM 332", "AO4x12bit", 0, 4, 60, 12, true, 0,
                      kStandard | kFiveVolts, 800)),
    diagnosing(analog("6ES7 332-5HF00-0AB0", "SM 332", "AO8x12bit", 0, 8, 100, 12, true, 0,
                      kStandard | kFiveVolts, 800)),

    analog("6ES7 334-0CE01-0AA0", "SM 334", "AI4/AO2x8bit", 4, 2, 55, 8, false, kFixed, kFixed,
           1'250),
    analog("6ES7 334-0KE00-0AB0", "SM 334", "AI4/AO2x12bit", 4, 2, 60, 12, false,
           kFixed | kThermometers, kFixed, 85'000),

    position(),

    other("6ES7 350-1AH03-0AE0", "FM 350-1", "counter", Kind::Function, 160),
    other("6ES7 351-1AH02-0AE0", "FM 351", "positioning", Kind::Function, 150),
    other("6ES7 352-1AH02-0AE0", "FM 352", "cam control", Kind::Function, 100),
    other("6ES7 353-1AH01-0AE0", "FM 353", "stepper motor", Kind::Function, 100),
    other("6ES7 354-1AH01-0AE0", "FM 354", "servo motor", Kind::Function, 100),
    other("6ES7 355-0VH10-0AE0", "FM 355 C", "closed-loop control", Kind::Function, 75),
    other("6ES7 357-4AH01-0AE0", "FM 357-2", "CNC path control", Kind::Function, 100),

    other("6ES7 340-1AH02-0AE0", "CP 340", "RS 232", Kind::Communication, 160),
    other("6ES7 340-1CH02-0AE0", "CP 340", "RS 422/485", Kind::Communication, 160),
    other("6ES7 341-1AH02-0AE0", "CP 341", "RS 232", Kind::Communication, 70),
    other("6GK7 342-5DA03-0XE0", "CP 342-5", "PROFIBUS DP", Kind::Communication, 150),
    other("6GK7 343-1EX30-0XE0", "CP 343-1", "Ethernet", Kind::Communication, 200),
    other("6GK7 343-1GX11-0XE0", "CP 343-1 IT", "Ethernet", Kind::Communication, 200),
    diagnosing(other("6GK7 343-2AH00-0XA0", "CP 343-2", "AS-Interface", Kind::Communication, 200))};

constexpr std::array kOnBoard{
    settable(digital("", "", "DI24/DO16", 24, 16, 0, kDc, kDirect), kDelaysOnBoard, 0xFFFFFF, 1),
    settable(digital("", "", "DI16/DO16", 16, 16, 0, kDc, kDirect), kDelaysOnBoard, 0xFFFF, 1),
    settable(digital("", "", "DI10/DO6", 10, 6, 0, kDc, kDirect), kDelaysOnBoard, 0x3FF, 1),
    compactAnalog(),
    counting(),
    positioning(),
    pointToPoint()};

}  // namespace

std::span<const ModuleType> moduleTypes() { return kModules; }
std::span<const ModuleType> onBoardTypes() { return kOnBoard; }

}  // namespace merker
