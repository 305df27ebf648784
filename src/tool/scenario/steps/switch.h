// switch RUN-P: the mode switch.
#pragma once

#include <string_view>
#include <utility>

#include "base/text.h"
#include "cpu/switch_panel.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Switch {
  static constexpr std::string_view kWords = "switch";

  cpu::SwitchPosition position = cpu::SwitchPosition::RunP;

  static constexpr std::pair<std::string_view, cpu::SwitchPosition> kPositions[] = {
      {"RUN-P", cpu::SwitchPosition::RunP},
      {"RUN", cpu::SwitchPosition::Run},
      {"STOP", cpu::SwitchPosition::Stop},
      {"MRES", cpu::SwitchPosition::Mres}};

  bool parse(const StepLine& line) {
    for (const auto& [word, one] : kPositions) {
      if (!equalsIgnoreCase(word, line.rest())) continue;
      position = one;
      return true;
    }
    return line.fail(ProblemCode::P0952, line.rest(), "RUN-P, RUN, STOP or MRES");
  }
  void resolve(const StepBinding&) {}
  bool perform(StepRun& run) const {
    auto* const panel = run.need<cpu::SwitchPanel>();
    if (panel != nullptr) panel->setSwitch(position);
    return panel != nullptr;
  }
};

}  // namespace merker::simulator::steps
