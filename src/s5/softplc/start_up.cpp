// Start-up: cold start and warm restart, power (S5-OB-01 … -04, S5-MEM-09).
#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kStartUpOb = 20;

}  // namespace

bool OperatingSystem::start(Start kind) {
  if (!state_.allows(kind)) return false;
  resume();
  prepareStart(kind);
  if (memoryLost_) {
    record_.set(ControlBit::URLAD);
    record_.set(ControlBit::NINEU);
    record_.stopWithout("user memory lost, load the program again");
    halt();
    return false;
  }
  if (const auto fault = checkStart(machine_, options_, active_, around_, sums_)) {
    raise(fault->trap, fault->also);
    return false;
  }
  record_.set(ControlBit::ADRBAU);
  record_.set(ControlBit::EOVH, machine_.periphery.inputPresent[active_.word(0)]);
  if (options_.macros != nullptr) options_.macros->restart(machine_);
  lookAround();
  if (mode() != Mode::Startup) return false;
  flags_.enterLevel(kStartUpOb, around_);
  if (!processor_.begin(kStartUpOb)) beginRun();
  return true;
}

void OperatingSystem::prepareStart(Start kind) {
  state_.start(kind);
  machine_.levels.clear();
  changes_.carryOut();
  record_.begin(kind);
  cycleActive_ = requested_ = false;
  alarmLevel_.forgetRequests();
  watch_.off();
  conditions_.forget();
  processor_.clearStp();
  if (kind == Start::Cold) segmentSwitch = kProgramSegment;
  clearAreas(kind == Start::Cold);
  flags_.start(kind == Start::Cold);
  takeMachineData();
}

// The images always; flags, timers and counters on a cold start.
void OperatingSystem::clearAreas(bool all) {
  images_.clear();
  if (!all) return;
  machine_.flags.fill(0);
  machine_.timers = {};
  machine_.counters = {};
}

void OperatingSystem::takeMachineData() {
  active_ = data_;
  const Raster raster =
      makeRaster(active_.samplingCode, active_.word(2), options_.variant, options_.software);
  schedule_.begin(machine_.clock, raster);
  environment_.timeBases = raster.timeBases;
  environment_.systemCommands = active_.systemCommands();
  environment_.lastTimer = active_.word(6);
  compiled_.forget();
  times_ = {};
}

void OperatingSystem::lookAround() {
  const bool unit = active_.bit(data_bit::kDistributed);
  conditions_.look(around_, options_.macros, unit, [this](Alarm alarm, ControlBit also) {
    raise(Trap{alarm, {}}, also);
    return mode() != Mode::Stop;
  });
}

void OperatingSystem::beginRun() {
  state_.run();
  record_.run();
  schedule_.begin(machine_.clock, schedule_.raster());
  flags_.startUpOver();
  alarmLevel_.watch(active_.word(0));
  watch_.begin(machine_.clock, cycleLimit());
  passCheckpoint();
}

// Segments 5 and 6 are buffered, segment 1 is not.
void OperatingSystem::powerOff() {
  if (mode() == Mode::Off) return;
  resume();
  machine_.levels.clear();
  cycleActive_ = false;
  changes_.carryOut();
  if (options_.macros != nullptr) options_.macros->stops();
  clearAreas(true);
  record_.powerOff();
  state_.powerOff();
}

void OperatingSystem::powerOn(bool buffered) {
  if (mode() != Mode::Off) return;
  state_.powerOn();
  around_.batteryGood = buffered;
  if (!buffered) {
    machine_.blocks.restore({}, {});
    memoryLost_ = true;
  }
  const bool warm = data_.bit(data_bit::kWarmRestart) && state_.canContinue() && buffered;
  start(warm ? Start::Warm : Start::Cold);
}

void OperatingSystem::setTerminal(unsigned inputByte, std::uint8_t value) {
  if (inputByte >= kImageBytes) return;
  machine_.periphery.inputs[inputByte] = value;
  alarmLevel_.terminalChanged(inputByte, value);
}

}  // namespace merker::sinumerik
