// expect LED RUN = on: an LED of the CPU.
#pragma once

#include <string>

#include "cpu/led_panel.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"

namespace merker::simulator::expectations {

struct Led {
  using Needs = cpu::LedPanel;
  static constexpr bool kSpeaksOfState = true;
  cpu::Light cpu::Leds::*led = nullptr;
  cpu::Light light = cpu::Light::On;
  block::Relation relation = block::Relation::Equal;  // or NotEqual

  bool parse(const StepLine& line, const Claim& claim);
  void resolve(const StepBinding&) {}
  bool holds(controller::Controller& plc) const { return agrees(seen(plc) == light, relation); }
  std::string actual(controller::Controller& plc) const;

 private:
  cpu::Light seen(const controller::Controller& plc) const {
    return controller::capability<cpu::LedPanel>(plc)->leds().*led;
  }
};

}  // namespace merker::simulator::expectations
