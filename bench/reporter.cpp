#include "reporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace merker::bench {
namespace {

using Run = benchmark::BenchmarkReporter::Run;

double counter(const Run& run, const char* name) {
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? 0 : static_cast<double>(found->second);
}

double measuredBy(const Run& run, Unit unit) {
  switch (unit) {
    case Unit::Seconds:
      return run.real_accumulated_time / static_cast<double>(run.iterations);
    case Unit::Rate:
      return counter(run, "items_per_second");
    case Unit::RealTime:
      return counter(run, "items_per_second") / 1e9;
    case Unit::Bytes:
      return counter(run, "bytes");
  }
  return 0;
}

std::string text(double value, Unit unit) {
  switch (unit) {
    case Unit::Seconds:
      return fmt::format("{:.1f} ms", value * 1e3);
    case Unit::Rate:
      return fmt::format("{:.2f} million/s", value / 1e6);
    case Unit::RealTime:
      return fmt::format("{:.1f} x real time", value);
    case Unit::Bytes:
      return value < 1e6 ? fmt::format("{:.1f} bytes", value)
                         : fmt::format("{:.0f} MB", value / 1e6);
  }
  return {};
}

std::string text(double value, Unit unit, Limit limit) {
  if (limit == Limit::None) return {};
  return (limit == Limit::AtMost ? "at most " : "at least ") + text(value, unit);
}

bool meets(double value, const Single& row, double speed) {
  if (row.limit == Limit::None) return true;
  if (row.unit == Unit::Bytes) speed = 1;
  return row.limit == Limit::AtMost ? value <= row.value / speed : value >= row.value * speed;
}

}  // namespace

void Reporter::ReportRuns(const std::vector<Run>& runs) {
  std::vector<const Run*> measured;
  for (const Run& run : runs)
    if (run.run_type == Run::RT_Iteration) measured.push_back(&run);
  if (measured.empty()) return;
  const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
  std::ranges::nth_element(measured, middle, {},
                           [](const Run* run) { return counter(*run, "items_per_second"); });
  report(**middle);
}

void Reporter::report(const Run& run) {
  const std::string full = run.benchmark_name(), name = full.substr(0, full.find('/'));
  const Single* const one = findSingle(name);
  const Pair* const two = findPair(name);
  if (run.error_occurred || (one == nullptr && two == nullptr)) {
    std::cout << fmt::format("{:<40}{}\n", name, run.error_message);
    allMet_ = false;
    return;
  }
  reached_[name] = measuredBy(run, one != nullptr ? one->unit : two->unit);
  further(name, run);
  std::cerr << fmt::format("measured: {}\n", one != nullptr ? one->label : two->label);
}

// Of the same run, but a figure of its own.
void Reporter::further(const std::string& name, const Run& run) {
  if (name == "BitLogicCompiled")
    reached_["CodeOfABitInstruction"] = counter(run, "bytes_per_instruction");
  if (name == "ThousandCpus") reached_["MemoryOfThousandCpus"] = counter(run, "bytes");
}

double Reporter::reached(std::string_view benchmark) const {
  const auto found = reached_.find(std::string(benchmark));
  return found == reached_.end() ? 0 : found->second;
}

void Reporter::print() {
  for (const Single& row : singles())
    if (reached(row.benchmark) > 0) single(row, reached(row.benchmark));
  for (const Pair& row : pairs())
    if (const double compiled = reached(std::string(row.benchmark) + "Compiled"); compiled > 0)
      pair(row, reached(row.benchmark), compiled);
}

void Reporter::single(const Single& row, double measured) {
  header(fmt::format("{:<58}{:>22}{:>28}\n", "", "measured", "required"));
  std::cout << fmt::format("{:<58}{:>22}{:>28}{}\n", row.label, text(measured, row.unit),
                           text(row.value, row.unit, row.limit),
                           verdict(meets(measured, row, 1), meets(measured, row, speed())));
}

void Reporter::pair(const Pair& row, double interpreted, double compiled) {
  constexpr const char* kLine = "{:<40}{:<14}{:>12}{:>12}{:>12}{:>8}{:>10}{}\n";
  header(fmt::format(fmt::runtime(kLine), "", "", "interpreter", "compiled", "required", "times",
                     "required", ""));
  const double ofC = row.share * reached(row.reference);
  const double wanted = std::max(row.compiled, ofC);
  const double times = interpreted > 0 ? compiled / interpreted : 0;
  const double scale = row.unit == Unit::Rate ? 1e6 : 1;
  const auto number = [](double value) {
    return value > 0 ? fmt::format("{:.1f}", value) : std::string();
  };
  const auto met = [&](double speed) {
    return compiled >= std::max(row.compiled * speed, ofC) && times >= row.times &&
           interpreted >= row.interpreted * speed;
  };
  std::cout << fmt::format(
      fmt::runtime(kLine), row.label, row.unit == Unit::Rate ? "million/s" : "x real time",
      number(interpreted / scale), number(compiled / scale), number(wanted / scale), number(times),
      number(row.times), verdict(met(1), met(speed())));
}

void Reporter::header(const std::string& text) {
  if (text == header_) return;
  std::cout << (header_.empty() ? "" : "\n") << text;
  header_ = text;
}

double Reporter::speed() const {
  const double limit = reached(kLimit);
  return limit > 0 ? std::min(1.0, limit / kReferenceSpeed) : 1;
}

std::string Reporter::verdict(bool met, bool metForItsSpeed) {
  allMet_ = allMet_ && metForItsSpeed;
  if (met) return {};
  return metForItsSpeed ? fmt::format("  reached for {:.2f} of the speed", speed()) : "  MISSED";
}

}  // namespace merker::bench
