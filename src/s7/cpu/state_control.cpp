#include "cpu/state_control.h"

#include <cassert>
#include <utility>

namespace merker::cpu {

StateControl::StateControl(Machine& machine, const Parts& parts)
    : machine_(machine),
      parts_(parts),
      stopEvent_{.event = static_cast<std::uint16_t>(Event::PowerOn)} {}

// S7-STATE-08
void StateControl::change(Mode to) {
  assert(isTransition(mode_, to));
  mode_ = to;
  if (to == Mode::Startup) parts_.modules.wake();
  parts_.modules.modeChanged();
}

void StateControl::standStill() {
  parts_.cycle.monitorOff();
  for (RuntimeMeter& meter : parts_.meters) meter.stop(machine_.clock);
  parts_.modules.disableOutputs(true);  // S7-STATE-02
}

void StateControl::goToStop(Event why, std::string reason, Place place, bool fault) {
  stopEvent_ = parts_.log.entry(static_cast<std::uint16_t>(why), std::move(reason), place);
  parts_.log.add(stopEvent_);
  stepping_ = false;
  if (executing()) frozenAt_ = machine_.clock;
  if (mode_ != Mode::Stop) {
    resumable_ = mode_ == Mode::Run && !fault;
    change(Mode::Stop);
  }
  stoppedByFault_ = fault;
  standStill();
  machine_.interrupt();
  parts_.points.reached(controller::CyclePoint::Stop);
}

void StateControl::stop(Event why) {
  if (mode_ == Mode::Stop) return;
  if (mode_ == Mode::Halt) parts_.log.report(Event::HaltToStop);
  goToStop(why, std::string(text(why)), {}, false);
}

void StateControl::stopByFault(Event why, std::string detail) {
  std::string reason(text(why));
  if (!detail.empty()) reason += ": " + detail;
  goToStop(why, std::move(reason), parts_.log.here(), true);
}

void StateControl::refuseStart(std::string why) {
  goToStop(Event::StopProgramSequence, "start refused: " + std::move(why), {}, true);
}

void StateControl::startup() {
  change(Mode::Startup);
  stoppedByFault_ = false;
}

void StateControl::halt(Place next) {
  if (!std::exchange(stepping_, false)) parts_.log.report(Event::HaltReached, next);
  beforeHalt_ = mode_;
  change(Mode::Halt);
  frozenAt_ = machine_.clock;
  parts_.modules.disableOutputs(true);
  machine_.interrupt();
}

void StateControl::endHalt(bool step) {
  stepping_ = step;
  if (!step) parts_.log.report(Event::HaltLeft);
  change(beforeHalt_);
}

void StateControl::tellHaltLeft() {
  if (std::exchange(stepping_, false)) parts_.log.report(Event::HaltLeft);
}

void StateControl::endStep() {
  mode_ = Mode::Halt;
  frozenAt_ = machine_.clock;
}

bool StateControl::losePower() {
  const bool running = executing();
  if (running) frozenAt_ = machine_.clock;
  resumable_ = running;
  if (mode_ == Mode::Halt) {  // without power it ends in STOP, whatever comes later
    stopEvent_ = parts_.log.entry(static_cast<std::uint16_t>(Event::HaltToStop),
                                  std::string(text(Event::HaltToStop)), {});
    parts_.log.add(stopEvent_);
  }
  mode_ = Mode::Stop;
  standStill();
  return running;
}

void StateControl::startOff() {
  mode_ = Mode::Stop;
  frozenAt_ = machine_.clock;
}

void StateControl::stopQuietly() {
  if (mode_ != Mode::Stop) change(Mode::Stop);
  frozenAt_ = machine_.clock;
  standStill();
}

void StateControl::runQuietly() {
  change(Mode::Startup);
  change(Mode::Run);
}

void StateControl::takeStop(const DiagnosticEvent& why, bool byFault) {
  stopEvent_ = why;
  stoppedByFault_ = byFault;
}

}  // namespace merker::cpu
