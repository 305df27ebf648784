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
  // With it the value is a share of what this one reached in the same run.
  std::string_view of{};
};

constexpr std::array kRequirements{
    Requirement{"Compile100000Lines", "compile 100,000 lines of AWL", Limit::AtMost, 2.0},
    Requirement{"StartOfASmallProgram", "start, compile and run a small program", Limit::AtMost,
                0.050},
    Requirement{"Instructions", "instructions", Limit::AtLeast, 100e6},
    Requirement{"FcCalls", "calls of an FC with three parameters", Limit::AtLeast, 3e6},
    // 240 000 a second of the machine, 100 times as fast (CNT-OVW-04)
    Requirement{"CountedEncoder", "counts of a 60 kHz encoder, quadruple", Limit::AtLeast, 24e6},
    Requirement{"Cycles", "cycles with process image", Limit::None, 0},
    Requirement{"BitLogicLimit", "bit operations, written in C++", Limit::None, 0},
    Requirement{"BitLogic", "bit instructions", Limit::None, 0},
    Requirement{"BitLogicCompiled", "bit instructions, compiled", Limit::AtLeast, 0.8,
                "BitLogicLimit"},
    Requirement{"MixedLoop", "mixed loop", Limit::None, 0},
    Requirement{"MixedLoopCompiled", "mixed loop, compiled", Limit::AtLeast, 0.4, "BitLogicLimit"},
    Requirement{"InstructionsCompiled", "instructions, compiled", Limit::AtLeast, 10,
                "Instructions"},
    Requirement{"Reals", "REAL", Limit::None, 0},
    Requirement{"RealsCompiled", "REAL, compiled", Limit::AtLeast, 10, "Reals"},
    Requirement{"Indirect", "indirect addressing", Limit::None, 0},
    Requirement{"IndirectCompiled", "indirect addressing, compiled", Limit::AtLeast, 10,
                "Indirect"},
    Requirement{"Timers", "timers and counters", Limit::None, 0},
    Requirement{"TimersCompiled", "timers and counters, compiled", Limit::AtLeast, 10, "Timers"},
    Requirement{"FcCallsCompiled", "calls of an FC, compiled", Limit::AtLeast, 50e6},
    Requirement{"Translate100000Lines", "100,000 lines to machine code", Limit::AtMost, 0.5},
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
  std::cout << fmt::format("{:<40}{:>20}{:>28}\n", "", "measured", "required");
  return true;
}

void RequirementReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs)
    if (run.run_type == Run::RT_Iteration) report(run);
}

void RequirementReporter::reportSize(double bytes) {
  constexpr double kMost = 20;
  std::cout << fmt::format("{:<40}{:>14.1f} bytes{:>22} bytes{}\n",
                           "machine code of a bit instruction", bytes,
                           fmt::format("at most {}", kMost), bytes <= kMost ? "" : "  MISSED");
  allMet_ = allMet_ && bytes <= kMost;
}

void RequirementReporter::report(const Run& run) {
  const Requirement* const r = find(run.benchmark_name());
  if (run.error_occurred || r == nullptr) {
    std::cout << fmt::format("{:<40}{}\n", run.benchmark_name(), run.error_message);
    allMet_ = false;
    return;
  }
  const auto rate = run.counters.find("items_per_second");
  if (rate != run.counters.end()) reached_[std::string(r->benchmark)] = rate->second;
  const double wanted = r->of.empty() ? r->value : r->value * reached_[std::string(r->of)];
  const double measured = r->limit == Limit::AtMost
                              ? run.real_accumulated_time / static_cast<double>(run.iterations)
                              : static_cast<double>(rate->second);
  const bool met = r->limit == Limit::None ||
                   (r->limit == Limit::AtMost ? measured <= r->value : measured >= wanted);
  const std::string required =
      r->limit == Limit::None
          ? ""
          : fmt::format("{} {}", r->limit == Limit::AtMost ? "at most" : "at least",
                        inUnits(wanted, r->limit));
  std::cout << fmt::format("{:<40}{:>20}{:>28}{}\n", r->label, inUnits(measured, r->limit),
                           required, met ? "" : "  MISSED");
  if (const auto size = run.counters.find("bytes_per_instruction");
      size != run.counters.end() && r->benchmark == "BitLogicCompiled")
    reportSize(size->second);
  allMet_ = allMet_ && met;
}

}  // namespace merker::bench
