#include "requirements.h"

#include <fmt/format.h>

#include <array>
#include <iostream>
#include <string_view>

namespace merker::bench {
namespace {

enum class Limit { None, AtMost, AtLeast };

struct Requirement {
  std::string_view benchmark, label;
  Limit limit;
  double value;  // seconds for AtMost, per second otherwise
};

constexpr std::array kRequirements{
    Requirement{"Compile100000Lines", "compile 100,000 lines of AWL", Limit::AtMost, 2.0},
    Requirement{"StartOfASmallProgram", "start, compile and run a small program", Limit::AtMost,
                0.050},
    Requirement{"Instructions", "instructions", Limit::AtLeast, 100e6},
    Requirement{"FcCalls", "calls of an FC with three parameters", Limit::AtLeast, 3e6},
    Requirement{"Cycles", "cycles with process image", Limit::None, 0},
};

const Requirement* find(const std::string& name) {
  for (const Requirement& r : kRequirements)
    if (name.substr(0, name.find('/')) == r.benchmark) return &r;
  return nullptr;
}

std::string inUnits(double value, Limit limit) {
  if (limit == Limit::AtMost) return fmt::format("{:.1f} ms", value * 1e3);
  return fmt::format("{:.2f} million/s", value / 1e6);
}

}  // namespace

bool RequirementReporter::ReportContext(const Context& /*context*/) {
  std::cout << fmt::format("{:<42}{:>18}{:>26}\n", "", "measured", "required");
  return true;
}

void RequirementReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs)
    if (run.run_type == Run::RT_Iteration) report(run);
}

void RequirementReporter::report(const Run& run) {
  const Requirement* const r = find(run.benchmark_name());
  if (run.error_occurred || r == nullptr) {
    std::cout << fmt::format("{:<42}{}\n", run.benchmark_name(), run.error_message);
    allMet_ = false;
    return;
  }
  const auto rate = run.counters.find("items_per_second");
  const double measured = r->limit == Limit::AtMost
                              ? run.real_accumulated_time / static_cast<double>(run.iterations)
                              : static_cast<double>(rate->second);
  const bool met = r->limit == Limit::None ||
                   (r->limit == Limit::AtMost ? measured <= r->value : measured >= r->value);
  const std::string required =
      r->limit == Limit::None
          ? ""
          : fmt::format("{} {}", r->limit == Limit::AtMost ? "at most" : "at least",
                        inUnits(r->value, r->limit));
  std::cout << fmt::format("{:<42}{:>18}{:>26}{}\n", r->label, inUnits(measured, r->limit),
                           required, met ? "" : "  MISSED");
  allMet_ = allMet_ && met;
}

}  // namespace merker::bench
