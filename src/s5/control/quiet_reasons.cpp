// Why cycles were computed, in words.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "control/cnc.h"

namespace merker::cnc {

std::uint64_t Cnc::cyclesPassedOver() const { return plc().operatingSystem().quiet().cycles(); }

namespace {

using sinumerik::Difference;

// As operands are written; empty: it has none.
std::string operand(const Difference& where) {
  if (where.area == "DB") return fmt::format("DB{}.DW {}", where.number, where.word);
  if (where.area == "T" || where.area == "Z") return fmt::format("{} {}", where.area, where.number);
  if (where.area == "E" || where.area == "A" || where.area == "M")
    return fmt::format("{}B {}", where.area, where.number);
  return where.area.starts_with('P') && where.area.size() == 2 ? fmt::format("PB {}", where.number)
                                                               : "";
}

Cnc::Reason changed(const Difference& where) {
  const std::string name = operand(where);
  if (where.area == "E" || where.area == "PE") return {.text = name + ", an input, changes"};
  if (where.area == "PA")
    return {.text = "output byte " + name + " changes",
            .changed = fmt::format("AB {}", where.number)};
  return {.text = (name.empty() ? std::string(where.area) : name) + " changes", .changed = name};
}

}  // namespace

std::vector<Cnc::Reason> Cnc::whyComputed() const {
  constexpr std::string_view kTexts[] = {
      "first cycle after something was asked or changed from outside",
      "",  // what changes is told
      "the blink clock (M 0.7), a timer or a job of a macro acts within the cycle",
      "OB 2, an alarm or a message",
      "a function macro is called",
      "the cycle takes another time than the one before, or more than the call raster",
      "each instruction is looked at or counted, or OB 1 works in thirds of the raster",
      "first cycle after the start",
      "not looked at: those before proved nothing, and looking costs time",
      "the same as the one before: the next ones need not be computed"};
  const sinumerik::QuietCycles& quiet = plc().operatingSystem().quiet();
  const auto& counts = quiet.counts();
  static_assert(std::size(kTexts) == std::tuple_size_v<sinumerik::QuietCycles::Counts>);
  std::vector<Reason> reasons;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const bool memory = i == static_cast<std::size_t>(sinumerik::NotQuiet::Memory);
    reasons.push_back(memory ? changed(quiet.lastDifference()) : Reason{std::string(kTexts[i])});
    reasons.back().cycles = counts[i];
  }
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::cycles);
  return reasons;
}

}  // namespace merker::cnc
