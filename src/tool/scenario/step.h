// A step of a scenario: one of the value types of steps/, with its place in the file
// (docs/formats/scenario.md).
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>

#include "scenario/steps/battery.h"
#include "scenario/steps/expect.h"
#include "scenario/steps/fault.h"
#include "scenario/steps/line_fault.h"
#include "scenario/steps/memory.h"
#include "scenario/steps/plant.h"
#include "scenario/steps/power.h"
#include "scenario/steps/repeat.h"
#include "scenario/steps/restart.h"
#include "scenario/steps/serial.h"
#include "scenario/steps/set.h"
#include "scenario/steps/signal.h"
#include "scenario/steps/station.h"
#include "scenario/steps/switch.h"
#include "scenario/steps/terminal.h"
#include "scenario/steps/trigger.h"
#include "scenario/steps/wait.h"

namespace merker::simulator {

// What every step has. The list below does not compile with one that lacks a part.
template <typename S>
concept IsStep = requires(S& step, const S& ready, const StepLine& line, const StepBinding& binding,
                          StepRun& run) {
  { S::kWords } -> std::convertible_to<std::string_view>;  // that it begins with: "cold restart"
  { step.parse(line) } -> std::same_as<bool>;
  step.resolve(binding);
  { ready.perform(run) } -> std::same_as<bool>;
};

template <IsStep... S>
using OneOf = std::variant<S...>;

using AnyStep =
    OneOf<steps::Set, steps::Wait, steps::Expect, steps::Run, steps::Stop, steps::ColdRestart,
          steps::WarmRestart, steps::HotRestart, steps::Switch, steps::PowerOff,
          steps::PowerOnUnbuffered, steps::PowerOn, steps::BatteryLow, steps::BatteryGood,
          steps::RemoveCard, steps::Trigger, steps::MemoryReset, steps::CopyRamToRom, steps::Force,
          steps::Unforce, steps::Fault, steps::Terminal, steps::Serial, steps::Pulses,
          steps::Encoder, steps::Plant, steps::Break, steps::Short, steps::Delay, steps::Mend,
          steps::Station, steps::Repeat>;

struct Step {
  Position position;
  std::string text;      // as written
  bool partner = false;  // the coupled control does it
  AnyStep does;
  std::size_t station = 0;  // of a project of several, which one does it
};

}  // namespace merker::simulator
