#include "softplc/operating_system.h"

#include <algorithm>
#include <utility>

#include "softplc/memory_size.h"
#include "softplc/periphery_check.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kCyclicOb = 1;

MachineData machineDataOf(const Options& options) {
  const bool withAlarmLevel = options.program.contains({mc5::BlockType::Ob, kAlarmOb});
  return options.machineData.value_or(MachineData::standard(withAlarmLevel));
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
      recorder_(options_.program, options_.coverage),
      compiled_(options_, machine_, environment_, recorder_, probes_),
      images_(machine_),
      alarmLevel_(processor_, flags_, times_, around_),
      record_(machine_, around_) {
  machine_.dataInEprom = options_.dataInEprom;
  environment_.macros = options_.macros;
  environment_.variant = options_.variant;
  mount(around_.modules, machine_.periphery);
}

void OperatingSystem::step(Instant limit) {
  if (state_.takeHoldNext() && hold()) return;
  if (macrosAreDue()) return serveMacros();
  if (mode() == Mode::Run) return runStep(limit);
  if (mode() == Mode::Startup) return execute(limit);
  machine_.clock = std::max(machine_.clock, limit);
}

bool OperatingSystem::macrosAreDue() const {
  return executes(mode()) && options_.macros != nullptr &&
         options_.macros->next() <= machine_.clock;
}

// Jobs of function macros go on beside the program. What stops the PLC shows its number in the
// accumulators (S5-FM-05), also when no program runs just then.
void OperatingSystem::serveMacros() {
  const bool idle = machine_.levels.empty();
  if (idle) machine_.levels.push_back({});
  raise(options_.macros->advance(machine_, machine_.clock));
  if (idle && !machine_.levels.empty()) machine_.levels.pop_back();
}

// Events in the order of their priority: monitoring, sampling, then the program.
void OperatingSystem::runStep(Instant limit) {
  const Instant now = machine_.clock;
  if (watch_.exceeded(now)) return raise(Trap{Alarm::CycleTime, {}});
  if (now >= schedule_.nextSample()) return sample();
  if (now >= schedule_.nextThird()) {
    times_.third = {};
    return schedule_.thirdBegun();
  }
  if (executable()) return execute(limit);
  if (betweenCycles() && requested_) return beginCycle();
  const Instant job = options_.macros != nullptr ? options_.macros->next() : Instant::never();
  machine_.clock = std::max(now, std::min({limit, schedule_.next(), watch_.overdue(), job}));
}

void OperatingSystem::levelEnded(std::uint8_t ob) {
  judgeRunTime(ob);
  if (mode() == Mode::Stop) return;
  if (ob == kCyclicOb) return endCycle();
  if (ob == kAlarmOb) return endAlarmLevel();
  if (processor_.stpSeen()) return raise(Trap{Alarm::Stp, {}});
  beginRun();
}

void OperatingSystem::raise(const Trap& trap, ControlBit also) {
  ++raised_;
  if (active_.stops(row(trap.alarm).reaction)) {
    resume();
    record_.stop(trap, also, mode() == Mode::Startup);
    return halt();
  }
  // A message: the fine bit in DB 1 and the group bit stay until the program resets them
  // (S5-ERR-03).
  record_.message(trap);
  if (diagnosis::showFault(machine_.blocks, trap.alarm)) flags_.fault();
}

void OperatingSystem::raise(const std::optional<Trap>& trap) {
  if (trap) raise(*trap, ControlBit::NONE);
}

void OperatingSystem::halt() {
  state_.stop();
  machine_.levels.clear();
  cycleActive_ = false;
  recorder_.forgetCalls();
  if (options_.macros != nullptr) options_.macros->stops();
  cyclePoints_.reached(controller::CyclePoint::Stop);
  changes_.carryOut();
}

void OperatingSystem::stopByProgrammer() {
  if (executes(mode()) || mode() == Mode::Halt) raise(Trap{Alarm::ProgrammerStop, {}});
}

void OperatingSystem::betweenCycles(std::function<void()> change) {
  changes_.add(std::move(change));
  if (betweenCycles()) changes_.carryOut();
}

void OperatingSystem::blocksChanged() {
  sums_.take(machine_.blocks);
  memoryLost_ = false;
}

ControlBits OperatingSystem::controlBits() const {
  ControlBits bits = record_.controlBits();
  bits.set(ControlBit::STOZUS, mode() == Mode::Stop);
  bits.set(ControlBit::STOANZ, mode() == Mode::Stop);
  bits.set(ControlBit::BATPUF, around_.batteryGood);
  bits.set(ControlBit::OBWIED, state_.ofProgram() == Mode::Startup && !machine_.levels.empty());
  return bits;
}

}  // namespace merker::sinumerik
