#include "softplc/operating_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/bcd.h"
#include "softplc/memory_size.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kStartUpOb = 20, kCyclicOb = 1, kAlarmOb = 2;
constexpr unsigned kAlarms = 6000;  // F000 shows numbers without it

MachineData machineDataOf(const Options& options) {
  const bool withAlarmLevel = options.program.contains({mc5::BlockType::Ob, kAlarmOb});
  return options.machineData.value_or(MachineData::standard(withAlarmLevel));
}

// A STOP that the program or the programmer wanted.
bool isWish(Alarm alarm) {
  return alarm == Alarm::ProgrammerStop || alarm == Alarm::Stp || alarm == Alarm::Sts;
}

Options completed(Options options) {
  if (options.variant == mc5::Variant::Cop) options.software = Software::Sw1;
  options.machineData = machineDataOf(options);
  return options;
}

Machine machineFor(const Options& options) {
  const MemorySize size = memorySize(options, *options.machineData);
  Machine machine(size.programWords, size.dataWords + kSystemDataWords);
  machine.layout = layoutOf(options, *options.machineData);
  return machine;
}

}  // namespace

OperatingSystem::OperatingSystem(const Options& options)
    : options_(completed(options)),
      data_(*options_.machineData),
      active_(data_),
      around_(options_.surroundings),
      machine_(machineFor(options_)),
      processor_(machine_, environment_),
      flags_(machine_),
      recorder_(options_.program, options_.coverage) {
  machine_.dataInEprom = options_.dataInEprom;
  environment_.macros = options_.macros;
  environment_.variant = options_.variant;
}

void OperatingSystem::step(Instant limit) {
  if (std::exchange(holdNext_, false) && hold()) return;
  if (macrosAreDue()) return serveMacros();
  if (mode_ == Mode::Run) return runStep(limit);
  if (mode_ == Mode::Startup) return execute(limit);
  machine_.clock = std::max(machine_.clock, limit);
}

bool OperatingSystem::macrosAreDue() const {
  return executes(mode_) && options_.macros != nullptr && options_.macros->next() <= machine_.clock;
}

// Jobs of function macros go on beside the program. What stops the PLC shows its number in the
// accumulators (S5-FM-05), also when no program runs just then.
void OperatingSystem::serveMacros() {
  const bool idle = machine_.levels.empty();
  if (idle) machine_.levels.push_back({});
  const auto trap = options_.macros->advance(machine_, machine_.clock);
  if (trap) raise(*trap);
  if (idle && !machine_.levels.empty()) machine_.levels.pop_back();
}

// Events in the order of their priority: monitoring, sampling, then the program.
void OperatingSystem::runStep(Instant limit) {
  const Instant now = machine_.clock;
  if (now > watchdog_) return raise({Alarm::CycleTime, {}});
  if (now >= schedule_.nextSample()) return sample();
  if (now >= schedule_.nextThird()) {
    times_.third = {};
    return schedule_.thirdBegun();
  }
  if (executable()) return execute(limit);
  if (betweenCycles() && requested_) return beginCycle();
  const Instant overdue = watchdog_ + Duration{1};
  const Instant job = options_.macros != nullptr ? options_.macros->next() : Instant::never();
  machine_.clock = std::max(now, std::min({limit, schedule_.next(), overdue, job}));
}

bool OperatingSystem::alarmLevelRuns() const {
  return !machine_.levels.empty() && machine_.levels.back().ob == kAlarmOb;
}

// When chopping, OB 1 rests once it has had its share of a third of the raster (S5-SCHED-06).
bool OperatingSystem::executable() const {
  if (machine_.levels.empty()) return false;
  if (alarmLevelRuns() || !active_.bit(data_bit::kChopping)) return true;
  return times_.third < shareOfThird();
}
Duration OperatingSystem::shareOfThird() const {
  return {schedule_.raster().call.ns / 3 * active_.word(1) / 100};
}

void OperatingSystem::execute(Instant limit) {
  if (runCompiled(horizon(limit))) return;
  if (probes_.any() && probes_.before(machine_)) return static_cast<void>(hold());
  const std::uint8_t ob = machine_.level().ob;
  const Instant before = machine_.clock;
  const bool stpBefore = processor_.stpSeen();
  if (recorder_.active()) recorder_.beforeStep(machine_);
  const Outcome outcome = processor_.step();
  if (recorder_.active()) recorder_.afterStep(processor_, outcome);
  if (probes_.any()) probes_.after(processor_, outcome);
  if (outcome == Outcome::Trapped) return raise(processor_.trap());
  if (processor_.stpSeen() && !stpBefore)
    stpPicture_ = takePicture(machine_, controlRegister(around_.batteryGood));
  if (ob != kStartUpOb) times_.charge(ob == kAlarmOb, machine_.clock - before);
  if (outcome == Outcome::LevelEnded && mode_ != Mode::Stop) levelEnded(ob);
}

// Load limits (S5-SCHED-05, -10), judged when a level ends: a loop without end is a matter of the
// watchdog, and an OB 2 that is requested again one of the processing delay.
void OperatingSystem::judgeRunTime(std::uint8_t ob) {
  const std::int64_t cyclicLimit = schedule_.raster().call.ns * active_.word(1) / 100;
  if (ob == kCyclicOb && !active_.bit(data_bit::kChopping) && times_.cycle.cyclic.ns > cyclicLimit)
    raise({Alarm::CyclicRunTime, {}});
  const bool exceeded = times_.alarmWindow() > alarmLimit();
  if (ob != kAlarmOb || !exceeded || alarmTimeReported_) return;
  alarmTimeReported_ = true;
  raise({Alarm::AlarmRunTime, {}});
}

Duration OperatingSystem::alarmLimit() const { return Duration::microseconds(active_.word(3)); }

void OperatingSystem::levelEnded(std::uint8_t ob) {
  judgeRunTime(ob);
  if (mode_ == Mode::Stop) return;
  if (ob == kCyclicOb) return endCycle();
  if (ob == kAlarmOb) return endAlarmLevel();
  if (processor_.stpSeen()) return raise({Alarm::Stp, {}});
  beginRun();
}

bool OperatingSystem::stops(Reaction reaction) const {
  switch (reaction) {
    case Reaction::Message:
      return false;
    case Reaction::Stop:
      return true;
    case Reaction::StopIfOb1:
      return active_.stopsOnCyclicTime();
    case Reaction::StopIfOb2:
      return active_.stopsOnAlarmTime();
    case Reaction::StopIfUnit:
      return active_.bit(data_bit::kStopOnUnit);
  }
  return true;
}

void OperatingSystem::raise(const Trap& trap, ControlBit also) {
  const bool stop = stops(row(trap.alarm).reaction);
  const unsigned alarm = number(trap.alarm);
  fineCode_.code = stop ? static_cast<std::uint16_t>(alarm - kAlarms) : std::uint16_t{0};
  fineCode_.number = static_cast<std::uint16_t>(toBcd(alarm, 4));
  fineCode_.words = trap.words;
  if (stop) return enterStop(trap, also);
  show(trap);
}

// A message: the fine bit in DB 1 and the group bit stay until the program resets them (S5-ERR-03).
void OperatingSystem::show(const Trap& trap) {
  alarms_.announce(number(trap.alarm), describe(trap.alarm), machine_.clock, false);
  const std::uint16_t bit = diagnosis::faultBit(trap.alarm);
  std::uint16_t* faults = diagnosis::word(machine_.blocks, diagnosis::kFaults);
  if (bit == 0) return;
  if (faults != nullptr) *faults = static_cast<std::uint16_t>(*faults | bit);
  flags_.fault();
}

std::string OperatingSystem::place() const {
  if (!picture_.interrupt.block) return {};
  return fmt::format(", {} word {}", toString(*picture_.interrupt.block),
                     picture_.interrupt.relativeStep);
}

void OperatingSystem::enterStop(const Trap& trap, ControlBit also) {
  resume();
  const bool stp = trap.alarm == Alarm::Stp && stpPicture_.has_value();
  picture_ = stp ? *stpPicture_ : takePicture(machine_, controlRegister(around_.batteryGood));
  addCause(picture_, machine_, trap.alarm);
  if (also == ControlBit::NAUAS) picture_.interrupt.causes.set(Cause::NAU);
  controlBits_.set(row(trap.alarm).control);
  controlBits_.set(also);
  controlBits_.set(mode_ == Mode::Startup ? ControlBit::MAFEHL : ControlBit::UAFEHL);
  noteStop(trap);
}

void OperatingSystem::noteStop(const Trap& trap) {
  const std::string text = describe(trap.alarm);
  alarms_.add(kPlcStop, "3 PLC-Stop", machine_.clock, true);
  alarms_.add(number(trap.alarm), text, machine_.clock, true);
  stoppedByFault_ = !isWish(trap.alarm);
  stopReason_ = text + place();
  alarms_.note(number(trap.alarm), "STOP: " + stopReason_, machine_.clock);
  halt();
}

void OperatingSystem::halt() {
  mode_ = Mode::Stop;
  machine_.levels.clear();
  cycleActive_ = false;
  recorder_.forgetCalls();
  if (options_.macros != nullptr) options_.macros->stops();
  runChanges();
}

void OperatingSystem::stopWithout(std::string text) {
  picture_ = takePicture(machine_, controlRegister(around_.batteryGood));
  if (!around_.batteryGood) picture_.interrupt.causes.set(Cause::BAU);
  controlBits_.set(ControlBit::MAFEHL);
  alarms_.add(kPlcStop, "3 PLC-Stop", machine_.clock, true);
  alarms_.note(kPlcStop, "STOP: " + text, machine_.clock);
  stopReason_ = std::move(text);
  stoppedByFault_ = true;
  halt();
}

void OperatingSystem::stopByProgrammer() {
  if (executes(mode_) || mode_ == Mode::Halt) raise({Alarm::ProgrammerStop, {}});
}

void OperatingSystem::betweenCycles(std::function<void()> change) {
  changes_.push_back(std::move(change));
  if (betweenCycles()) runChanges();
}

void OperatingSystem::runChanges() {
  const auto changes = std::move(changes_);
  changes_.clear();
  for (const auto& change : changes) change();
}

void OperatingSystem::blocksChanged() {
  sums_.take(machine_.blocks);
  memoryLost_ = false;
}

ControlBits OperatingSystem::controlBits() const {
  ControlBits bits = controlBits_;
  bits.set(ControlBit::STOZUS, mode_ == Mode::Stop);
  bits.set(ControlBit::STOANZ, mode_ == Mode::Stop);
  bits.set(ControlBit::BATPUF, around_.batteryGood);
  const Mode mode = mode_ == Mode::Halt ? held_.mode : mode_;
  bits.set(ControlBit::OBWIED, mode == Mode::Startup && !machine_.levels.empty());
  return bits;
}

void OperatingSystem::passCheckpoint() {
  ++checkpoints_;
  if (observer_) observer_();
}

}  // namespace merker::sinumerik
