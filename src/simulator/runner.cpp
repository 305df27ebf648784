#include "simulator/runner.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cpu/cpu.h"
#include "cpu/trigger.h"
#include "simulator/expectations.h"
#include "simulator/start.h"
#include "station/station.h"

namespace merker::simulator {
namespace {

using controller::Controller;
using controller::Mode;
using station::Station;

class Runner {
 public:
  Runner(Controller& plc, TestResult& result, std::optional<Until> until = {})
      : plc_(plc), device_(dynamic_cast<Station*>(&plc)), result_(result), until_(until) {}

  bool run(const std::vector<Step>& steps);
  void endState(const Scenario& scenario);

 private:
  bool fail(const Position& position, std::string message);
  bool reached(const Step& step) const;
  bool perform(const Step& step);
  bool performByPartner(const Step& step);
  bool performByControl(const Step& step);
  bool noPartner(const Step& step);
  bool performOnDevice(const Step& step);
  bool set(const Step& step);
  bool setTerminals(const Step& step);
  bool repeat(const Step& step);
  bool restarted(const Step& step, Start how);
  bool powered(const Step& step);
  bool hotRestart(const Step& step);
  bool refused(const Step& step);
  bool hasNone(const Step& step, std::string_view what);
  bool noDevice(const Step& step);
  bool unknown(const Step& step);
  bool memoryReset(const Step& step);
  bool copyRamToRom(const Step& step);
  bool waitCycles(const Step& step);
  bool expect(const Step& step);
  bool during(const Step& step, Instant end);
  bool within(const Step& step, Instant end);
  bool miss(const Step& step);

  Controller& plc_;
  Station* device_;  // null: no SIMATIC S7
  TestResult& result_;
  std::optional<Until> until_;
  Axes axes_;
  bool speaksOfState_ = false;
};

bool Runner::fail(const Position& position, std::string message) {
  result_.failures.push_back({position, plc_.now(), std::move(message)});
  return false;
}

bool Runner::run(const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    if (!perform(step)) return false;
    if (until_ && reached(step)) return false;
  }
  return true;
}

// A step ends in STOP, or is the one that was asked for.
bool Runner::reached(const Step& step) const {
  if (until_->line != 0) return step.position.line >= until_->line;
  return plc_.mode() == Mode::Stop && plc_.powered();
}

// Both move through time: a start of the one lasts as long for the other.
bool Runner::performByPartner(const Step& step) {
  Controller* const partner = plc_.partner();
  if (partner == nullptr) return noPartner(step);
  partner->advanceTo(plc_.now());
  Step own = step;
  own.partner = false;
  const bool done = Runner(*partner, result_).perform(own);
  plc_.advanceTo(std::max(plc_.now(), partner->now()));
  return done;
}

bool Runner::noPartner(const Step& step) {
  return fail(
      step.position,
      fmt::format("{}: there is no coupled control ([coupling] in merker.toml)", step.text));
}

// What a SINUMERIK has of the steps for devices.
bool Runner::performByControl(const Step& step) {
  if (step.kind == StepKind::BatteryLow || step.kind == StepKind::BatteryGood)
    return plc_.batteryFails(step.kind == StepKind::BatteryLow) || noDevice(step);
  if (step.kind != StepKind::Fault) return noDevice(step);
  const std::string reason = plc_.fault(step.fault.module, step.fault.words, step.fault.there);
  return reason.empty() || fail(step.position, step.text + ": " + reason);
}

bool Runner::perform(const Step& step) {
  if (step.partner) return performByPartner(step);
  switch (step.kind) {
    case StepKind::Set:
    case StepKind::Force:
      return set(step);
    case StepKind::Wait:
      plc_.advanceTo(plc_.now() + step.duration);
      return true;
    case StepKind::WaitCycles:
      return waitCycles(step);
    case StepKind::Expect:
      return expect(step);
    case StepKind::Run:
      return plc_.mode() == Mode::Run || restarted(step, &Controller::start);
    case StepKind::Stop:
      plc_.stop();
      return true;
    case StepKind::ColdRestart:
      return restarted(step, &Controller::coldRestart);
    case StepKind::WarmRestart:
      return restarted(step, &Controller::warmRestart);
    case StepKind::PowerOff:
      plc_.powerOff();
      return true;
    case StepKind::PowerOn:
    case StepKind::PowerOnUnbuffered:
      plc_.powerOn(step.kind == StepKind::PowerOn);
      return true;
    case StepKind::MemoryReset:
      return memoryReset(step);
    case StepKind::Unforce:
      if (!powered(step)) return false;
      plc_.unforce();
      return true;
    case StepKind::Repeat:
      return repeat(step);
    case StepKind::HotRestart:
    case StepKind::Switch:
    case StepKind::Trigger:
    case StepKind::BatteryLow:
    case StepKind::BatteryGood:
    case StepKind::RemoveCard:
    case StepKind::CopyRamToRom:
    case StepKind::Fault:
    case StepKind::Signal:
    case StepKind::Terminal:
    case StepKind::Plant:
      return device_ != nullptr ? performOnDevice(step) : performByControl(step);
  }
  return unknown(step);
}

// What only a SIMATIC S7 station has.
bool Runner::performOnDevice(const Step& step) {
  switch (step.kind) {
    case StepKind::HotRestart:
      return hotRestart(step);
    case StepKind::Switch:
      device_->setSwitch(step.switchPosition);
      return true;
    case StepKind::Trigger:
      if (!powered(step)) return false;
      cpu::trigger(device_->cpu(), step.trigger);
      return true;
    case StepKind::BatteryLow:
    case StepKind::BatteryGood:
      device_->setBattery(step.kind == StepKind::BatteryLow);
      return true;
    case StepKind::RemoveCard:  // S7-CPU-03
      if (!powered(step)) return false;
      device_->cpu().requestMemoryReset();
      return true;
    case StepKind::CopyRamToRom:
      return copyRamToRom(step);
    case StepKind::Fault:
      apply(step.fault, *device_->rack());
      return true;
    case StepKind::Signal:
      simulator::apply(step.signal, axes_, *device_->rack(), plc_.now());
      return true;
    case StepKind::Terminal:
      return setTerminals(step);
    case StepKind::Plant:
      for (const PlantValue& value : step.plants)
        simulator::apply(value, *device_->plants(), *device_->rack(), plc_.now());
      return true;
    case StepKind::Set:
    case StepKind::Force:
    case StepKind::Unforce:
    case StepKind::Wait:
    case StepKind::WaitCycles:
    case StepKind::Expect:
    case StepKind::Run:
    case StepKind::Stop:
    case StepKind::ColdRestart:
    case StepKind::WarmRestart:
    case StepKind::PowerOff:
    case StepKind::PowerOn:
    case StepKind::PowerOnUnbuffered:
    case StepKind::MemoryReset:
    case StepKind::Repeat:
      break;
  }
  return unknown(step);
}

// Every kind has its case above: the compiler tells one that is forgotten.
bool Runner::unknown(const Step& step) {
  return fail(step.position, fmt::format("{}: nobody performs this step", step.text));
}

bool Runner::noDevice(const Step& step) {
  return fail(step.position,
              fmt::format("{}: {} has nothing of this kind; it is a step for SIMATIC S7", step.text,
                          plc_.modelName()));
}

// What lies at a terminal does not need the CPU; its memory and its forces do.
bool needsPower(const Step& step, const Assignment& assignment) {
  const address::Reference& reference = assignment.operand.reference;
  const Area area = reference.operand.area;
  const bool terminal = reference.operand.kind == address::OperandKind::Memory &&
                        (area == Area::Input || area == Area::Peripheral) && !reference.outputSide;
  return step.kind == StepKind::Force || !terminal;
}

bool Runner::set(const Step& step) {
  for (const Assignment& assignment : step.assignments) {
    if (needsPower(step, assignment) && !powered(step)) return false;
    const std::string reason = apply(assignment, step.kind == StepKind::Force, plc_);
    if (!reason.empty()) return fail(assignment.operand.position, reason);
  }
  return true;
}

bool Runner::setTerminals(const Step& step) {
  for (const TerminalValue& terminal : step.terminals) {
    const std::string reason = simulator::set(terminal, *device_->rack(), plc_.now());
    if (!reason.empty()) return fail(terminal.position, reason);
  }
  return true;
}

bool Runner::repeat(const Step& step) {
  for (std::uint64_t i = 0; i < step.count; ++i)
    if (!run(step.body)) return false;
  return true;
}

bool Runner::restarted(const Step& step, Start how) {
  if (!powered(step)) return false;
  if (how == &Controller::coldRestart && !plc_.hasColdRestart())
    return hasNone(step, "cold restart");
  // What a SINUMERIK finds wrong when it starts is an alarm that a scenario may expect.
  return restart(plc_, how) || (device_ == nullptr && plc_.stoppedByFault()) || refused(step);
}

bool Runner::hotRestart(const Step& step) {
  if (!powered(step)) return false;
  if (!device_->model().hotRestart) return hasNone(step, "hot restart");
  return device_->hotRestart() ||
         fail(step.position,
              fmt::format("{}: the CPU refuses: there is no interrupted program to go on with{}",
                          step.text, because(plc_)));
}

bool Runner::hasNone(const Step& step, std::string_view what) {
  return fail(step.position,
              fmt::format("{}: the CPU refuses: {} has no {}", step.text, plc_.modelName(), what));
}

bool Runner::refused(const Step& step) {
  return fail(step.position, fmt::format("{}: the CPU refuses{}", step.text, because(plc_)));
}

bool Runner::copyRamToRom(const Step& step) {
  if (!powered(step)) return false;
  const std::string reason = device_->copyRamToRom();
  return reason.empty() || fail(step.position, step.text + ": " + reason);
}

bool Runner::powered(const Step& step) {
  return plc_.powered() ||
         fail(step.position,
              fmt::format("{}: the CPU is switched off; 'power on' comes first", step.text));
}

bool Runner::memoryReset(const Step& step) {
  if (!powered(step)) return false;
  if (plc_.mode() != Mode::Stop) plc_.stop();
  plc_.memoryReset();
  return true;
}

bool Runner::waitCycles(const Step& step) {
  const std::uint64_t end = plc_.cycles() + step.count;
  plc_.advanceCycles(step.count);
  if (plc_.cycles() >= end) return true;
  return fail(step.position, fmt::format("{}: the CPU is in {}{}", step.text, modeName(plc_.mode()),
                                         because(plc_)));
}

// "expected A 1.2 = 1 within 300ms, A 1.2 is 0".
bool Runner::miss(const Step& step) {
  const std::string_view words =
      std::string_view(step.text).substr(std::string_view("expect").size());
  return fail(step.position,
              fmt::format("expected {}, {}", trim(words), actual(step.expectation, plc_)));
}

bool Runner::expect(const Step& step) {
  if (device_ == nullptr && needsDevice(step.expectation)) return noDevice(step);
  if (step.expectation.partner && plc_.partner() == nullptr) return noPartner(step);
  if (step.expectation.what == Expectation::What::Mode ||
      step.expectation.what == Expectation::What::Stack ||
      step.expectation.what == Expectation::What::Diagnostics)
    speaksOfState_ = true;
  const Instant end = plc_.now() + step.expectation.duration;
  if (step.expectation.when == Expectation::When::During) return during(step, end);
  if (step.expectation.when == Expectation::When::Within) return within(step, end);
  return holds(step.expectation, plc_) || miss(step);
}

// Now, at every cycle boundary, and at the end.
bool Runner::during(const Step& step, Instant end) {
  for (;;) {
    if (!holds(step.expectation, plc_)) return miss(step);
    if (plc_.now() >= end) return true;
    advanceToNextLook(plc_, end);
  }
}

// Ends at the first cycle boundary at which it holds.
bool Runner::within(const Step& step, Instant end) {
  for (;;) {
    if (holds(step.expectation, plc_)) return true;
    if (plc_.now() >= end) return miss(step);
    advanceToNextLook(plc_, end);
  }
}

void Runner::endState(const Scenario& scenario) {
  if (!plc_.stoppedByFault() || speaksOfState_) return;
  const Position& position =
      scenario.steps.empty() ? scenario.position : scenario.steps.back().position;
  fail(position, "expected no fault, the CPU went to STOP: " + stopText(plc_));
}

}  // namespace

TestResult runScenario(const Scenario& scenario, Controller& plc) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  Runner runner(plc, result);
  const std::string reason = refusal(plc);
  // A fault that ends the start is a state that a scenario may expect; a refused start is not.
  const bool refused = !reason.empty() && !plc.stoppedByFault();
  if (refused) result.failures.push_back({scenario.position, plc.now(), reason});
  if (!refused && runner.run(scenario.steps)) runner.endState(scenario);
  result.end = plc.now();
  return result;
}

TestResult runUntil(const Scenario& scenario, const Until& until, Controller& plc) {
  TestResult result{scenario.position.file, scenario.name, {}, {}};
  const std::string reason = refusal(plc);
  if (!reason.empty()) result.failures.push_back({scenario.position, plc.now(), reason});
  const bool ended = plc.mode() == Mode::Stop && until.line == 0;
  if (reason.empty() && !ended) (void)Runner(plc, result, until).run(scenario.steps);
  result.end = plc.now();
  return result;
}

}  // namespace merker::simulator
