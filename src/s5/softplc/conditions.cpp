#include "softplc/conditions.h"

#include <array>

namespace merker::sinumerik {
namespace {

struct Condition {
  Alarm alarm;
  ControlBit also;
  bool ofUnit;
  bool (*holds)(const Surroundings&, const Macros*);
};
constexpr std::array kConditions{
    Condition{Alarm::Jumpers, ControlBit::NONE, false,
              [](const Surroundings& s, const Macros*) { return !s.jumpersRight; }},
    Condition{Alarm::MasterPlc, ControlBit::NONE, false,
              [](const Surroundings& s, const Macros* macros) {
                return !s.masterPlcRuns || (macros != nullptr && !macros->masterPlcRuns());
              }},
    Condition{Alarm::UnitSilent, ControlBit::NAUAS, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.mains; }},
    Condition{Alarm::UnitSilent, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.answers; }},
    Condition{Alarm::UnitTransmission, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.transmission; }},
    Condition{Alarm::UnitChanged, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return s.unit.changed; }},
    Condition{Alarm::UnitTemperature, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return s.unit.overTemperature; }}};

}  // namespace

void Conditions::look(const Surroundings& around, const Macros* macros, bool withUnit,
                      const Begins& begins) {
  static_assert(kConditions.size() <= decltype(holding_){}.size());
  for (std::size_t i = 0; i < kConditions.size(); ++i) {
    const Condition& condition = kConditions[i];
    const bool holds = condition.holds(around, macros) && (withUnit || !condition.ofUnit);
    const bool fresh = holds && !holding_[i];
    holding_[i] = holds;
    if (fresh && !begins(condition.alarm, condition.also)) return;
  }
}

}  // namespace merker::sinumerik
