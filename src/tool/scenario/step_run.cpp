#include "scenario/step_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/runner.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

StepRun::StepRun(Controller& plc, TestResult& result, const Until* until)
    : StepRun({NamedPlc{{}, &plc}}, result, until) {}

StepRun::StepRun(std::vector<NamedPlc> plcs, TestResult& result, const Until* until)
    : result_(result), until_(until) {
  for (NamedPlc& plc : plcs) stations_.push_back({std::move(plc), {}, false});
}

bool StepRun::run(const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    if (!perform(step)) return false;
    if (until_ != nullptr && reached(step)) return false;
  }
  return true;
}

// A step ends in STOP, or is the one that was asked for.
bool StepRun::reached(const Step& step) {
  if (until_->line != 0) return step.position.line >= until_->line;
  return plc().mode() == Mode::Stop && plc().powered();
}

bool StepRun::perform(const Step& step) {
  at_ = step.station;
  return step.partner ? performByPartner(step) : performHere(step);
}

// Each step performs itself: one that cannot does not compile.
bool StepRun::performHere(const Step& step) {
  step_ = &step;
  return std::visit([this](const IsStep auto& one) { return one.perform(*this); }, step.does);
}

// Both move through time: a start of the one lasts as long for the other.
bool StepRun::performByPartner(const Step& step) {
  step_ = &step;
  Controller* const partner = plc().partner();
  if (partner == nullptr) return noPartner();
  partner->advanceTo(plc().now());
  const bool done = StepRun(*partner, result_).performHere(step);
  if (std::holds_alternative<steps::MemoryReset>(step.does)) forces_.clearPartner();
  plc().advanceTo(std::max(plc().now(), partner->now()));
  return done;
}

bool StepRun::failAt(const Position& position, std::string message) {
  result_.failures.push_back({position, plc().now(), std::move(message)});
  return false;
}

bool StepRun::fail(std::string_view reason) {
  return failAt(step_->position, fmt::format("{}: {}", step_->text, reason));
}

bool StepRun::powered(const Controller& plc) {
  return plc.powered() || fail("the CPU is switched off; use 'power on' first");
}

bool StepRun::powered(const address::Reference& operand) {
  return powered(operand.station == 0 ? plc() : *stations_[operand.station - 1u].plc.plc);
}

bool StepRun::lacks(std::string_view what) {
  return fail(fmt::format("{} has no {}", plc().modelName(), what));
}

bool StepRun::noPartner() {
  return fail("there is no coupled control or station ([coupling] or [[station]] in merker.toml)");
}

}  // namespace merker::simulator
