#include "scenario/expectation.h"

namespace merker::simulator {

using controller::Controller;
using station::Station;

bool needsStation(const AnyExpectation& expectation) {
  return std::visit([]<IsExpectation E>(const E&) { return !CanLookAt<E, Controller>; },
                    expectation);
}

bool speaksOfState(const AnyExpectation& expectation) {
  return std::visit([]<IsExpectation E>(const E&) { return E::kSpeaksOfState; }, expectation);
}

bool holds(const AnyExpectation& expectation, Controller& plc, Station* station) {
  return std::visit(
      [&]<IsExpectation E>(const E& one) {
        if constexpr (CanLookAt<E, Controller>)
          return one.holds(plc);
        else
          return one.holds(*station);
      },
      expectation);
}

std::string actual(const AnyExpectation& expectation, Controller& plc, Station* station) {
  return std::visit(
      [&]<IsExpectation E>(const E& one) {
        if constexpr (CanLookAt<E, Controller>)
          return one.actual(plc);
        else
          return one.actual(*station);
      },
      expectation);
}

}  // namespace merker::simulator
