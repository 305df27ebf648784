// wait 250ms, wait 3 cycles: lets virtual time pass.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "scenario/duration.h"
#include "scenario/state_text.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Wait {
  static constexpr std::string_view kWords = "wait";

  Duration duration;
  std::optional<std::uint64_t> cycles;  // instead of a duration

  bool parse(const StepLine& line) {
    std::string_view unit = line.rest();
    const std::string_view number = takeWord(unit);
    if (equalsIgnoreCase(unit, "cycles") || equalsIgnoreCase(unit, "cycle"))
      return line.number(number, cycles.emplace());
    const auto length = parseDuration(line.rest());
    if (!length)
      return line.fail(ProblemCode::P0953, line.rest().empty() ? number : line.rest(), line.rest());
    duration = *length;
    return true;
  }

  void resolve(const StepBinding&) {}

  bool perform(StepRun& run) const {
    controller::Controller& plc = run.plc();
    if (!cycles) {
      plc.advanceTo(plc.now() + duration);
      return true;
    }
    const std::uint64_t end = plc.cycles() + *cycles;
    plc.advanceCycles(*cycles);
    if (plc.cycles() >= end) return true;
    return run.fail(fmt::format("the CPU is in {}{}", modeName(plc.mode()), because(plc)));
  }
};

}  // namespace merker::simulator::steps
