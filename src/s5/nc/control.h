// The NC side of SINUMERIK 810/820 as its PLC sees it: data that FB 56 … 58, 61 and 62 read and
// write. A value; axes move and programs run because somebody outside says so.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nc/number_format.h"
#include "softplc/surroundings.h"

namespace merker::nc {

constexpr unsigned kAxes = 5, kSpindles = 2, kChannels = 2;
constexpr unsigned kFeedTypes = 3;  // G94, G95, G98
constexpr unsigned kDataWords = 5000, kDataBytes = 5000;
constexpr unsigned kTools = 99, kToolValues = 16;
constexpr unsigned kChannelParameters = 500, kCentralParameters = 100;
constexpr unsigned kSettableGroups = 4, kProgrammableGroups = 2, kLevels = 4;

// Lengths and angles are counts of the input resolution: 0.001 mm or 0.0001 inch.
using Count = std::int32_t;

struct Axis {
  Count position = 0;  // actual, machine
  // Two's complement, in units of the position control (FB 57).
  std::int32_t followingError = 0;
  std::array<Number, kFeedTypes> feed{};
  std::uint8_t channel = 1;  // in which it is programmed
  bool operator==(const Axis&) const = default;
};

struct ProgramPointer {
  // Level 0: type (0 none, 1 main program, 2 subprogram), program, block; else subprogram, passes,
  // block (S5-FM-43).
  std::array<std::int32_t, 3> values{};
  bool operator==(const ProgramPointer&) const = default;
};

struct Channel {
  std::array<Number, kFeedTypes> pathFeed{};
  std::array<Number, 2> externalFeed{};  // linear, per revolution
  std::array<ProgramPointer, kLevels> pointers{};
  std::uint8_t settableGroup = 1;  // G54 … G57 in force: 1..4
  bool operator==(const Channel&) const = default;
};

struct ZeroOffset {
  Count coarse = 0, fine = 0;
  bool operator==(const ZeroOffset&) const = default;
};

struct Control {
  InputSystem inputSystem = InputSystem::Metric;
  std::vector<std::int32_t> machineData = std::vector<std::int32_t>(kDataWords);
  std::vector<std::int32_t> settingData = std::vector<std::int32_t>(kDataWords);
  std::vector<std::uint8_t> machineDataBytes = std::vector<std::uint8_t>(kDataBytes);  // 5000 …
  std::vector<std::uint8_t> settingDataBytes = std::vector<std::uint8_t>(kDataBytes);
  std::vector<std::array<Number, kToolValues>> tools =
      std::vector<std::array<Number, kToolValues>>(kTools);  // D 1 …
  std::array<std::array<Number, kChannelParameters>, kChannels> parameters{};
  std::array<Number, kCentralParameters> centralParameters{};  // R 900 …

  std::array<std::array<ZeroOffset, kAxes>, kSettableGroups> settable{};     // G54 … G57
  std::array<std::array<Count, kAxes>, kProgrammableGroups> programmable{};  // G58, G59
  std::array<Count, kAxes> external{}, preset{};

  std::array<Axis, kAxes> axes{};
  std::array<std::int32_t, kSpindles> spindleSpeed{};  // actual, per minute
  std::array<Channel, kChannels> channels{};
  std::vector<std::uint16_t> alarms;  // pending, in the order they came
  bool machiningStop = false;         // while an alarm is pending, machining stands still (NC-BB2)
  sinumerik::NcSide signals;  // to MB 17 … MB 24; alarm and machining stop follow `alarms`
  bool operator==(const Control&) const = default;

  // An alarm that is pending already is not raised again.
  void raise(std::uint16_t alarm);
  void clear(std::uint16_t alarm);
  // All zero offsets of an axis in force (0 = first axis).
  std::int64_t sumOffset(unsigned axis) const;
  std::int64_t workpiecePosition(unsigned axis) const {
    return axes.at(axis).position - sumOffset(axis);
  }
};

// The battery has failed without power: machine and setting data, tools, offsets, R parameters are
// lost. Axes stay where they are.
void forgetBuffered(Control& control);

}  // namespace merker::nc
