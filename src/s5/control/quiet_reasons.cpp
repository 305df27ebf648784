// Why cycles were computed, in words.
#include <algorithm>
#include <functional>
#include <iterator>

#include "control/cnc.h"

namespace merker::cnc {

std::uint64_t Cnc::cyclesPassedOver() const { return plc().operatingSystem().quiet().cycles(); }

std::vector<Cnc::Reason> Cnc::whyComputed() const {
  constexpr std::string_view kTexts[] = {
      "first cycle after something was asked or changed from outside",
      "flags, images, timers, counters or data change",
      "the blink clock (M 0.7), a timer or a job of a macro acts within the cycle",
      "OB 2, an alarm or a message",
      "a function macro is called",
      "the cycle takes another time than the one before, or more than the call raster",
      "each instruction is looked at or counted, or OB 1 works in thirds of the raster"};
  const auto& counts = plc().operatingSystem().quiet().counts();
  static_assert(std::size(kTexts) == std::tuple_size_v<sinumerik::QuietCycles::Counts>);
  std::vector<Reason> reasons;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] != 0) reasons.push_back({std::string(kTexts[i]), counts[i]});
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::cycles);
  return reasons;
}

}  // namespace merker::cnc
