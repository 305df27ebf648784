// Start-up: cold start and warm restart, power (S5-OB-01 … -04, S5-MEM-09).
#include <algorithm>
#include <array>

#include "softplc/operating_system.h"
#include "softplc/periphery_check.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kStartUpOb = 20, kProgramSegment = 5;

// Conditions around the PLC that are alarms (S5-ERR-02). Those of the unit need MD 2002 bit 4.
struct Condition {
  Alarm alarm;
  ControlBit also;
  bool ofUnit;
  bool (*holds)(const Surroundings&, const Macros*);
};
constexpr std::array kConditions{
    Condition{Alarm::Jumpers, ControlBit::NONE, false,
              [](const Surroundings& s, const Macros*) { return !s.jumpersRight; }},
    Condition{Alarm::MasterPlc, ControlBit::NONE, false,
              [](const Surroundings& s, const Macros* macros) {
                return !s.masterPlcRuns || (macros != nullptr && !macros->masterPlcRuns());
              }},
    Condition{Alarm::UnitSilent, ControlBit::NAUAS, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.mains; }},
    Condition{Alarm::UnitSilent, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.answers; }},
    Condition{Alarm::UnitTransmission, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return !s.unit.transmission; }},
    Condition{Alarm::UnitChanged, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return s.unit.changed; }},
    Condition{Alarm::UnitTemperature, ControlBit::NONE, true,
              [](const Surroundings& s, const Macros*) { return s.unit.overTemperature; }}};

}  // namespace

bool OperatingSystem::start(Start kind) {
  if (mode_ == Mode::Off) return false;
  if (kind == Start::Warm && warmInterrupted_) return false;
  resume();
  prepareStart(kind);
  if (memoryLost_) {
    controlBits_.set(ControlBit::URLAD);
    controlBits_.set(ControlBit::NINEU);
    stopWithout("user memory lost, load the program again");
    return false;
  }
  if (const auto fault = checkStart(machine_, options_, active_, around_, sums_)) {
    raise(fault->trap, fault->also);
    return false;
  }
  controlBits_.set(ControlBit::ADRBAU);
  controlBits_.set(ControlBit::EOVH, machine_.periphery.inputPresent[active_.word(0)]);
  if (options_.macros != nullptr) options_.macros->restart(machine_);
  lookAround();
  if (mode_ != Mode::Startup) return false;
  flags_.enterLevel(kStartUpOb, around_);
  if (!processor_.begin(kStartUpOb)) beginRun();
  return true;
}

void OperatingSystem::prepareStart(Start kind) {
  mode_ = Mode::Startup;
  startKind_ = kind;
  machine_.levels.clear();
  runChanges();
  alarms_.clear();
  alarms_.note(0, kind == Start::Cold ? "Neustart (cold start)" : "Wiederanlauf (warm restart)",
               machine_.clock);
  stopReason_.clear();
  stoppedByFault_ = cycleActive_ = requested_ = false;
  warmInterrupted_ = false;
  waitingEdges_ = {};
  watchdog_ = Instant::never();
  conditions_.assign(kConditions.size(), false);
  processor_.clearStp();
  stpPicture_.reset();
  picture_ = {};
  controlBits_ = {};
  controlBits_.set(kind == Start::Cold ? ControlBit::NEUSTA : ControlBit::WIEDAN);
  if (kind == Start::Cold) {
    fineCode_ = {};
    segmentSwitch = kProgramSegment;
  }
  clearAreas(kind == Start::Cold);
  flags_.start(kind == Start::Cold);
  takeMachineData();
}

// The images always; flags, timers and counters on a cold start.
void OperatingSystem::clearAreas(bool all) {
  machine_.inputs.fill(0);
  machine_.outputs.fill(0);
  machine_.periphery.outputs.fill(0);
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
  compiledVersion_ = ~std::uint64_t{0};
  times_ = {};
}

// A condition is an alarm when it begins.
void OperatingSystem::lookAround() {
  const bool unit = active_.bit(data_bit::kDistributed);
  for (std::size_t i = 0; i < kConditions.size(); ++i) {
    const Condition& condition = kConditions[i];
    const bool holds = condition.holds(around_, options_.macros) && (unit || !condition.ofUnit);
    const bool begins = holds && !conditions_[i];
    conditions_[i] = holds;
    if (begins) raise({condition.alarm, {}}, condition.also);
    if (mode_ == Mode::Stop) return;
  }
}

void OperatingSystem::beginRun() {
  mode_ = Mode::Run;
  alarms_.note(0, "RUN", machine_.clock);
  schedule_.begin(machine_.clock, schedule_.raster());
  flags_.startUpOver();
  const unsigned byte = active_.word(0);
  alarmInput_.begin(machine_.periphery.inputs[byte], isDistributed(around_.modules, byte)
                                                         ? AlarmInput::kDistributed
                                                         : AlarmInput::kCentral);
  cycleStart_ = machine_.clock;
  watchdog_ = cycleStart_ + Duration::milliseconds(active_.word(5));
  passCheckpoint();
}

// Segments 5 and 6 are buffered, segment 1 is not.
void OperatingSystem::powerOff() {
  if (mode_ == Mode::Off) return;
  resume();
  warmInterrupted_ = mode_ == Mode::Startup && startKind_ == Start::Warm;
  runBeforePowerOff_ = executes(mode_);
  machine_.levels.clear();
  cycleActive_ = false;
  runChanges();
  if (options_.macros != nullptr) options_.macros->stops();
  clearAreas(true);
  alarms_.clear();
  alarms_.note(0, "power off", machine_.clock);
  mode_ = Mode::Off;
}

void OperatingSystem::powerOn(bool buffered) {
  if (mode_ != Mode::Off) return;
  mode_ = Mode::Stop;
  around_.batteryGood = buffered;
  if (!buffered) {
    machine_.blocks.restore({}, {});
    memoryLost_ = true;
  }
  const bool warm =
      data_.bit(data_bit::kWarmRestart) && runBeforePowerOff_ && !warmInterrupted_ && buffered;
  start(warm ? Start::Warm : Start::Cold);
}

void OperatingSystem::setTerminal(unsigned inputByte, std::uint8_t value) {
  if (inputByte >= kImageBytes) return;
  machine_.periphery.inputs[inputByte] = value;
  if (inputByte == active_.word(0)) alarmInput_.change(value, machine_.clock);
}

}  // namespace merker::sinumerik
