#include "scenario/expectations/led.h"

#include <array>
#include <utility>

#include "base/text.h"

namespace merker::simulator::expectations {
namespace {

using cpu::Leds;
using cpu::Light;
using LedRow = std::pair<std::string_view, Light Leds::*>;
using LightRow = std::pair<std::string_view, Light>;

constexpr std::array kLeds = {LedRow{"SF", &Leds::sf},     LedRow{"BF", &Leds::bf},
                              LedRow{"BATF", &Leds::batf}, LedRow{"DC5V", &Leds::dc5v},
                              LedRow{"FRCE", &Leds::frce}, LedRow{"RUN", &Leds::run},
                              LedRow{"STOP", &Leds::stop}};
constexpr std::array kLights = {LightRow{"off", Light::Off}, LightRow{"on", Light::On},
                                LightRow{"slow", Light::Slow}, LightRow{"fast", Light::Fast}};

// Whether a row has this name; `value` becomes its value.
template <typename Rows, typename Value>
bool find(const Rows& rows, std::string_view word, Value& value) {
  for (const auto& [name, one] : rows) {
    if (!equalsIgnoreCase(name, word)) continue;
    value = one;
    return true;
  }
  return false;
}

}  // namespace

bool Led::parse(const StepLine& line, const Claim& claim) {
  relation = claim.relation;
  const auto orWhole = [&](std::string_view part) { return part.empty() ? claim.whole : part; };
  if (!claim.comparesEqual())
    return line.fail(ProblemCode::P0952, claim.whole, "LED NAME = or LED NAME <>");
  if (!find(kLeds, claim.subject, led))
    return line.fail(ProblemCode::P0952, orWhole(claim.subject),
                     "SF, BF, BATF, DC5V, FRCE, RUN or STOP");
  if (!find(kLights, claim.value, light))
    return line.fail(ProblemCode::P0952, orWhole(claim.value),
                     "off, on, slow (0.5 Hz) or fast (2 Hz)");
  return true;
}

std::string Led::actual(controller::Controller& plc) const {
  const auto shown = static_cast<std::size_t>(seen(plc));
  return "it is " + std::string(kLights[shown].first);
}

}  // namespace merker::simulator::expectations
