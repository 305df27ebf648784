#include "scenario/self_check.h"

#include <set>

#include "scenario/start.h"
#include "scenario/state_text.h"

namespace merker::simulator {
namespace {

constexpr Duration kLongest = Duration::seconds(10);

// Checks in the order of their lines; one line may have been compiled into several places.
struct ByLine {
  bool operator()(const Position& a, const Position& b) const {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  }
};

void collect(const controller::Controller& plc, TestResult& result) {
  std::set<Position, ByLine> lines, reached;
  for (const auto& check : plc.checkResults()) {
    lines.insert(check.check->position);
    if (check.reached > 0) reached.insert(check.check->position);
    for (const controller::CheckFailure& failure : check.failures)
      result.failures.push_back({check.check->position, failure.time, "expected " + failure.text});
  }
  for (const Position& line : lines)
    if (!reached.contains(line))
      result.failures.push_back({line, plc.now(), "the check was never reached"});
}

}  // namespace

bool hasChecks(std::string_view source) { return source.find("//=") != std::string_view::npos; }

TestResult runSelfChecks(const std::string& file, controller::Controller& plc) {
  TestResult result{file, "self-checks", {}, {}};
  const std::string reason = startFresh(plc);
  // OB 100 may contain all there is and stop the CPU: only a refusal or a fault fails.
  if (!reason.empty() && plc.stopReason().empty()) {
    result.failures.push_back({Position{file}, plc.now(), reason});
    return result;
  }
  const Instant end = plc.now() + kLongest;
  while (plc.now() < end && plc.mode() != controller::Mode::Stop) advanceToNextLook(plc, end);
  result.end = plc.now();
  if (plc.stoppedByFault())
    result.failures.push_back(
        {Position{file}, plc.now(), "the CPU went to STOP: " + stopText(plc)});
  collect(plc, result);
  return result;
}

}  // namespace merker::simulator
