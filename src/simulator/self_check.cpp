#include "simulator/self_check.h"

#include <set>

#include "simulator/runner.h"

namespace merker::simulator {
namespace {

constexpr Duration kLongest = Duration::seconds(10);

// Checks in the order of their lines; one line may have been compiled into several places.
struct ByLine {
  bool operator()(const Position& a, const Position& b) const {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  }
};

void collect(const station::Station& station, TestResult& result) {
  std::set<Position, ByLine> lines, reached;
  for (const auto& check : station.checkResults()) {
    lines.insert(check.check->position);
    if (check.reached > 0) reached.insert(check.check->position);
    for (const station::CheckFailure& failure : check.failures)
      result.failures.push_back({check.check->position, failure.time, "expected " + failure.text});
  }
  for (const Position& line : lines)
    if (!reached.contains(line))
      result.failures.push_back({line, station.now(), "the check was never reached"});
}

}  // namespace

bool hasChecks(std::string_view source) { return source.find("//=") != std::string_view::npos; }

TestResult runSelfChecks(const std::string& file, station::Station& station) {
  TestResult result{file, "self-checks", {}, {}};
  const std::string reason = startFresh(station);
  // OB 100 may contain all there is and stop the CPU: only a refusal or a fault fails.
  if (!reason.empty() && station.stopReason().empty()) {
    result.failures.push_back({Position{file}, station.now(), reason});
    return result;
  }
  const Instant end = station.now() + kLongest;
  while (station.now() < end && station.mode() != station::Mode::Stop)
    advanceToNextLook(station, end);
  result.end = station.now();
  if (station.stoppedByFault())
    result.failures.push_back(
        {Position{file}, station.now(), "the CPU went to STOP: " + station.stopReason()});
  collect(station, result);
  return result;
}

}  // namespace merker::simulator
