#include "simulator/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "simulator/comparison.h"
#include "simulator/duration.h"
#include "simulator/long_value.h"

namespace merker::simulator {
namespace {

using station::Mode;
using station::Station;

// A startup OB that never ends is ended by nothing on the real CPU (S7-STATE-11); a test must end.
constexpr Duration kLongestStartup = Duration::seconds(60);

std::string_view name(Mode mode) {
  constexpr std::array<std::string_view, 4> kNames = {"STOP", "STARTUP", "RUN", "HALT"};
  return kNames[static_cast<std::size_t>(mode)];
}

bool containsIgnoreCase(std::string_view text, std::string_view part) {
  return upper(text).find(upper(part)) != std::string::npos;
}

std::string because(const Station& station) {
  return station.mode() == Mode::Stop ? ": " + station.stopReason() : std::string();
}

// Restart of either kind, and the startup OBs up to RUN.
bool restart(Station& station, bool cold) {
  if (station.mode() != Mode::Stop) station.stop();
  if (!(cold ? station.coldRestart() : station.warmRestart())) return false;
  const Instant limit = station.now() + kLongestStartup;
  while (station.mode() == Mode::Startup && station.now() < limit)
    advanceToNextLook(station, limit);
  return true;
}

class Runner {
 public:
  Runner(Station& station, TestResult& result)
      : station_(station),
        result_(result),
        read_([&station](const mc7::Reference& reference) { return station.read(reference); }) {}

  bool run(const std::vector<Step>& steps);
  void endState(const Scenario& scenario);

 private:
  bool fail(const Position& position, std::string message);
  bool perform(const Step& step);
  bool set(const Step& step);
  bool setTerminals(const Step& step);
  bool repeat(const Step& step);
  bool restarted(const Step& step, bool cold);
  bool powered(const Step& step);
  bool refused(const Step& step);
  bool memoryReset(const Step& step);
  bool copyRamToRom(const Step& step);
  bool waitCycles(const Step& step);
  bool expect(const Step& step);
  bool during(const Step& step, Instant end);
  bool within(const Step& step, Instant end);
  bool miss(const Step& step);
  bool holds(const Expectation& e);
  bool inDiagnostics(const std::string& words) const;
  std::string actual(const Expectation& e) const;
  std::string newestEntry() const;

  Station& station_;
  TestResult& result_;
  Reader read_;
  bool speaksOfState_ = false;
};

bool Runner::fail(const Position& position, std::string message) {
  result_.failures.push_back({position, station_.now(), std::move(message)});
  return false;
}

bool Runner::run(const std::vector<Step>& steps) {
  for (const Step& step : steps)
    if (!perform(step)) return false;
  return true;
}

bool Runner::perform(const Step& step) {
  switch (step.kind) {
    case StepKind::Set:
    case StepKind::Force:
      return set(step);
    case StepKind::Wait:
      station_.advanceTo(station_.now() + step.duration);
      return true;
    case StepKind::WaitCycles:
      return waitCycles(step);
    case StepKind::Expect:
      return expect(step);
    case StepKind::Run:
      return station_.mode() == Mode::Run || restarted(step, false);
    case StepKind::Stop:
      station_.stop();
      return true;
    case StepKind::ColdRestart:
      return restarted(step, true);
    case StepKind::WarmRestart:
      return restarted(step, false);
    case StepKind::HotRestart:
      return station_.hotRestart() || refused(step);
    case StepKind::Switch:
      station_.setSwitch(step.switchPosition);
      return true;
    case StepKind::Trigger:
      cpu::trigger(station_.cpu(), step.trigger);
      return true;
    case StepKind::PowerOnUnbuffered:
      station_.powerOn(false);
      return true;
    case StepKind::BatteryLow:
    case StepKind::BatteryGood:
      station_.setBattery(step.kind == StepKind::BatteryLow);
      return true;
    case StepKind::PowerOff:
      station_.powerOff();
      return true;
    case StepKind::PowerOn:
      station_.powerOn();
      return true;
    case StepKind::MemoryReset:
      return memoryReset(step);
    case StepKind::CopyRamToRom:
      return copyRamToRom(step);
    case StepKind::Unforce:
      station_.unforce();
      return true;
    case StepKind::Repeat:
      return repeat(step);
    case StepKind::Fault:
      apply(step.fault, *station_.rack());
      return true;
    case StepKind::Terminal:
      return setTerminals(step);
  }
  return true;
}

bool Runner::set(const Step& step) {
  for (const Assignment& assignment : step.assignments) {
    const std::string reason = apply(assignment, step.kind == StepKind::Force, station_);
    if (!reason.empty()) return fail(assignment.operand.position, reason);
  }
  return true;
}

bool Runner::setTerminals(const Step& step) {
  for (const TerminalValue& terminal : step.terminals) {
    const std::string reason = simulator::set(terminal, *station_.rack(), station_.now());
    if (!reason.empty()) return fail(terminal.position, reason);
  }
  return true;
}

bool Runner::repeat(const Step& step) {
  for (std::uint64_t i = 0; i < step.count; ++i)
    if (!run(step.body)) return false;
  return true;
}

bool Runner::restarted(const Step& step, bool cold) {
  if (!powered(step)) return false;
  if (cold && !station_.model().coldRestart)
    return fail(step.position, fmt::format("{}: the CPU refuses: {} has no cold restart", step.text,
                                           station_.model().name));
  return restart(station_, cold) || refused(step);
}

bool Runner::refused(const Step& step) {
  return fail(step.position, fmt::format("{}: the CPU refuses{}", step.text, because(station_)));
}

bool Runner::copyRamToRom(const Step& step) {
  const std::string reason = station_.copyRamToRom();
  return reason.empty() || fail(step.position, step.text + ": " + reason);
}

bool Runner::powered(const Step& step) {
  return station_.powered() ||
         fail(step.position,
              fmt::format("{}: the CPU is switched off; 'power on' comes first", step.text));
}

bool Runner::memoryReset(const Step& step) {
  if (!powered(step)) return false;
  if (station_.mode() != Mode::Stop) station_.stop();
  station_.memoryReset();
  return true;
}

bool Runner::waitCycles(const Step& step) {
  const std::uint64_t end = station_.cycles() + step.count;
  station_.advanceCycles(step.count);
  if (station_.cycles() >= end) return true;
  return fail(step.position, fmt::format("{}: the CPU is in {}{}", step.text, name(station_.mode()),
                                         because(station_)));
}

bool Runner::inDiagnostics(const std::string& words) const {
  for (const auto& entry : station_.diagnostics())
    if (containsIgnoreCase(fmt::format("16#{:04X} {}", entry.event, entry.text), words))
      return true;
  return false;
}

// Values are those at the end of a cycle: in the middle of one they may be on their way.
bool Runner::holds(const Expectation& e) {
  switch (e.what) {
    case Expectation::What::Values:
      station_.settle();
      if (isLong(e.left)) return longHolds(e.left, e.relation, e.right, station_);
      return simulator::holds(e.left, e.relation, e.right, read_);
    case Expectation::What::Mode:
      return (station_.mode() == e.mode) == (e.relation == block::Relation::Equal);
    case Expectation::What::Diagnostics:
      return inDiagnostics(e.words);
    case Expectation::What::Terminal:
      station_.settle();
      return simulator::holds(e.terminal, e.relation, *station_.rack());
    case Expectation::What::Led:
      return (station_.leds().*e.led == e.light) == (e.relation == block::Relation::Equal);
  }
  return false;
}

std::string Runner::newestEntry() const {
  if (station_.diagnostics().empty()) return "the diagnostic buffer is empty";
  const auto& last = station_.diagnostics().back();
  return fmt::format("the newest entry is 16#{:04X} {}", last.event, last.text);
}

// What is there instead.
std::string Runner::actual(const Expectation& e) const {
  const bool stopped = station_.mode() == Mode::Stop;
  switch (e.what) {
    case Expectation::What::Values:
      return fmt::format("{} is {}", e.left.text,
                         isLong(e.left) ? actualLong(e.left, e.right, station_)
                                        : actualValue(e.left, e.right, read_)) +
             (stopped ? fmt::format(" (the CPU is in STOP{})", because(station_)) : "");
    case Expectation::What::Mode:
      return fmt::format("mode is {}{}", name(station_.mode()), because(station_));
    case Expectation::What::Diagnostics:
      return newestEntry();
    case Expectation::What::Terminal:
      return fmt::format("{} is {}", e.terminal.text,
                         simulator::actualValue(e.terminal, *station_.rack()));
    case Expectation::What::Led:
      return fmt::format("it is {}", simulator::name(station_.leds().*e.led));
  }
  return {};
}

// "expected A 1.2 = 1 within 300ms, A 1.2 is 0".
bool Runner::miss(const Step& step) {
  const std::string_view words =
      std::string_view(step.text).substr(std::string_view("expect").size());
  return fail(step.position, fmt::format("expected {}, {}", trim(words), actual(step.expectation)));
}

bool Runner::expect(const Step& step) {
  if (step.expectation.what == Expectation::What::Mode ||
      step.expectation.what == Expectation::What::Diagnostics)
    speaksOfState_ = true;
  const Instant end = station_.now() + step.expectation.duration;
  if (step.expectation.when == Expectation::When::During) return during(step, end);
  if (step.expectation.when == Expectation::When::Within) return within(step, end);
  return holds(step.expectation) || miss(step);
}

// Now, at every cycle boundary, and at the end.
bool Runner::during(const Step& step, Instant end) {
  for (;;) {
    if (!holds(step.expectation)) return miss(step);
    if (station_.now() >= end) return true;
    advanceToNextLook(station_, end);
  }
}

// Ends at the first cycle boundary at which it holds.
bool Runner::within(const Step& step, Instant end) {
  for (;;) {
    if (holds(step.expectation)) return true;
    if (station_.now() >= end) return miss(step);
    advanceToNextLook(station_, end);
  }
}

void Runner::endState(const Scenario& scenario) {
  if (!station_.stoppedByFault() || speaksOfState_) return;
  const Position& position =
      scenario.steps.empty() ? scenario.position : scenario.steps.back().position;
  fail(position, "expected no fault, the CPU went to STOP: " + station_.stopReason());
}

}  // namespace

// A STOP inside a call lets time run to the end of that call, so calls are short; in STOP nothing
// happens any more.
void advanceToNextLook(Station& station, Instant end) {
  constexpr Duration kSlice = Duration::milliseconds(1);
  const bool stopped = station.mode() == Mode::Stop;
  station.advanceToCheckpoint(stopped ? end : std::min(end, station.now() + kSlice));
}

std::string startFresh(Station& station) {
  if (station.mode() != Mode::Stop) station.stop();
  station.memoryReset();
  if (!restart(station, false)) return "the CPU does not start" + because(station);
  if (station.mode() == Mode::Run) return {};
  return fmt::format("the CPU does not reach RUN{}", because(station));
}

TestResult runScenario(const Scenario& scenario, Station& station) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  Runner runner(station, result);
  const std::string reason = startFresh(station);
  // A fault in the startup OB is a state that a scenario may expect; a refused start is not.
  const bool refused = !reason.empty() && !station.stoppedByFault();
  if (refused) result.failures.push_back({scenario.position, station.now(), reason});
  if (!refused && runner.run(scenario.steps)) runner.endState(scenario);
  result.end = station.now();
  return result;
}

}  // namespace merker::simulator
