// expect LED RUN = on: an LED of the CPU.
#pragma once

#include <string>

#include "cpu/leds.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "station/station.h"

namespace merker::simulator::expectations {

struct Led {
  static constexpr bool kSpeaksOfState = true;
  cpu::Light cpu::Leds::*led = nullptr;
  cpu::Light light = cpu::Light::On;
  block::Relation relation = block::Relation::Equal;  // or NotEqual

  bool parse(const StepLine& line, const Claim& claim);
  void resolve(const StepBinding&) {}
  bool holds(station::Station& station) const {
    return agrees(station.leds().*led == light, relation);
  }
  std::string actual(station::Station& station) const;
};

}  // namespace merker::simulator::expectations
