#include "softplc/plc.h"

#include <utility>

namespace merker::sinumerik {
namespace {

// How far beyond its end a call may run to reach the end of a cycle that never comes.
constexpr Duration kLongestCycle = Duration::seconds(10);
// An OB 20 without end is ended by nothing; one that lasts so long is not waited for.
constexpr Duration kLongestStartUp = Duration::milliseconds(200);

}  // namespace

struct Plc::Parts {
  explicit Parts(const Options& options) : os(options) {}

  OperatingSystem os;
  std::vector<std::string> refused;
  Instant started;      // the last start-up
  Plc* self = nullptr;  // whom the observer gets to see; moves along
  std::function<void(Plc&)> observer;
};

Plc::Plc(const Options& options) : parts_(std::make_unique<Parts>(options)) {
  parts_->self = this;
  Programmer loader(parts_->os);
  for (const auto& [id, block] : program())
    if (std::string text = loader.load(block); !text.empty())
      parts_->refused.push_back(toString(id) + ": " + text);
}
Plc::~Plc() = default;
Plc::Plc(Plc&& other) noexcept : parts_(std::move(other.parts_)) { parts_->self = this; }
Plc& Plc::operator=(Plc&& other) noexcept {
  parts_ = std::move(other.parts_);
  if (parts_) parts_->self = this;
  return *this;
}

const mc5::Program& Plc::program() const { return parts_->os.options().program; }
const std::vector<std::string>& Plc::refused() const { return parts_->refused; }

Mode Plc::mode() const { return parts_->os.mode(); }
bool Plc::stoppedByFault() const { return mode() == Mode::Stop && parts_->os.record().byFault(); }
std::string Plc::stopReason() const {
  return mode() == Mode::Stop ? parts_->os.record().reason() : std::string();
}
bool Plc::coldStart() {
  parts_->started = now();
  return parts_->os.start(Start::Cold);
}
bool Plc::warmStart() {
  parts_->started = now();
  return parts_->os.start(Start::Warm);
}
void Plc::stop() {
  parts_->os.quiet().forget();
  parts_->os.stopByProgrammer();
}
void Plc::powerOff() {
  parts_->os.quiet().forget();
  parts_->os.powerOff();
}
bool Plc::hold() {
  parts_->os.quiet().forget();
  return parts_->os.hold();
}
void Plc::holdNext() { parts_->os.holdNext(); }
bool Plc::resume() {
  if (mode() != Mode::Halt) return false;
  parts_->started = parts_->started + (now() - parts_->os.heldSince());
  return parts_->os.resume();
}
void Plc::powerOn(bool buffered) {
  parts_->started = now();
  parts_->os.powerOn(buffered);
}

Retained Plc::retained() const {
  const BlockMemory& blocks = machine().blocks;
  const auto part = [](const std::vector<std::uint16_t>& memory, std::uint32_t used) {
    return std::vector<std::uint16_t>(memory.begin(), memory.begin() + used);
  };
  return {part(blocks.program(), blocks.programUsed()), part(blocks.data(), blocks.dataUsed())};
}

void Plc::restore(const Retained& memory) {
  parts_->os.powerOff();
  machine().blocks.restore(memory.program, memory.data);
  parts_->os.blocksChanged();
}

Instant Plc::now() const { return machine().clock; }
std::uint64_t Plc::cycles() const { return parts_->os.cycles(); }
std::uint64_t Plc::instructions() const { return parts_->os.instructions(); }

void Plc::advanceTo(Instant t) {
  while (now() < t) {
    parts_->os.passQuiet(t);
    if (now() < t) parts_->os.step(t);
  }
}

void Plc::passQuietCycles(Instant limit) { parts_->os.passQuiet(limit); }
void Plc::passOverQuietCycles(bool on) { parts_->os.quiet().on = on; }

void Plc::runTo(Instant t) {
  while (executes(mode()) && now() < t) parts_->os.step(t);
}

void Plc::runToCheckpoint(Instant t) {
  OperatingSystem& os = parts_->os;
  const std::uint64_t before = os.checkpoints();
  while (executes(mode()) && now() < t && os.checkpoints() == before) os.step(t);
}

bool Plc::settle(Duration longest) {
  OperatingSystem& os = parts_->os;
  const bool starts = mode() == Mode::Startup;
  const Instant end = starts ? parts_->started + kLongestStartUp : now() + kLongestCycle;
  const Instant latest = std::min(end, now() + longest);
  const auto ended = [&os] { return os.betweenCycles() || os.mode() == Mode::Halt; };
  while (!ended() && now() < latest) os.step(latest);
  return ended();
}

void Plc::advanceCycles(std::uint64_t count) {
  for (; count > 0 && executes(mode()); --count) {
    const std::uint64_t first = cycles();
    parts_->os.passQuiet(Instant::never(), count);
    count -= cycles() - first;
    if (count == 0) break;
    const std::uint64_t before = cycles();
    const Instant latest = now() + kLongestCycle;
    while (cycles() == before && executes(mode()) && now() < latest) parts_->os.step(latest);
    settle();
  }
}

bool Plc::advanceToCheckpoint(Instant limit) {
  OperatingSystem& os = parts_->os;
  const std::uint64_t before = os.checkpoints();
  while (now() < limit && os.checkpoints() == before) os.step(limit);
  return os.checkpoints() != before;
}

bool Plc::runOb1(Duration most) { return parts_->os.runOb1(most); }
void Plc::translate() { parts_->os.translate(); }

void Plc::onCycle(std::function<void(Plc&)> observer) {
  parts_->observer = std::move(observer);
  Parts* parts = parts_.get();
  parts->os.onCheckpoint([parts] {
    if (parts->observer) parts->observer(*parts->self);
  });
}

void Plc::onCyclePoint(controller::CyclePoints::Monitor monitor) {
  parts_->os.onCyclePoint(std::move(monitor));
}

std::optional<std::uint32_t> Plc::read(const Reference& variable) const {
  return readValue(parts_->os, variable);
}
bool Plc::write(const Reference& variable, std::uint32_t value) {
  parts_->os.quiet().forget();
  return writeValue(parts_->os, variable, value);
}
bool Plc::writeImage(const Reference& variable, std::uint32_t value) {
  parts_->os.quiet().forget();
  return sinumerik::writeImage(parts_->os, variable, value);
}
bool Plc::force(const Reference& variable, std::uint32_t value) {
  parts_->os.quiet().forget();
  return forceValue(parts_->os, variable, value);
}
void Plc::unforce() {
  parts_->os.quiet().forget();
  parts_->os.forces().clear();
}

bool Plc::probe(mc5::BlockId block, Probe* probe) {
  parts_->os.quiet().forget();
  return parts_->os.probe(block, probe);
}
const PlacedProbes& Plc::probes() const { return parts_->os.probes(); }
std::optional<CodePlace> Plc::place() const { return nextPlace(machine()); }
std::optional<Instant> Plc::heldSince() const {
  return mode() == Mode::Halt ? std::optional(parts_->os.heldSince()) : std::nullopt;
}

std::vector<CheckResult> Plc::checkResults() const { return parts_->os.recorder().results(); }
const Executed& Plc::executed() const { return parts_->os.recorder().executed(); }

const std::vector<DiagnosticEntry>& Plc::diagnostics() const {
  return parts_->os.record().alarms().history();
}
std::vector<PendingAlarm> Plc::alarms() const { return parts_->os.record().alarms().shown(); }
bool Plc::acknowledge(unsigned alarm) {
  parts_->os.quiet().forget();
  return parts_->os.record().alarms().acknowledge(alarm);
}
void Plc::raise(const Trap& trap) {
  parts_->os.quiet().forget();
  parts_->os.raise(trap);
}

MachineData& Plc::machineData() {
  parts_->os.quiet().forget();
  return parts_->os.machineData();
}
Surroundings& Plc::surroundings() {
  parts_->os.quiet().forget();
  return parts_->os.surroundings();
}
Programmer Plc::programmer() {
  parts_->os.quiet().forget();
  return Programmer(parts_->os);
}
unsigned Plc::loadPerMille() const {
  return static_cast<unsigned>(parts_->os.runTimes().lastRaster.ns * 1000 /
                               parts_->os.schedule().raster().call.ns);
}
Machine& Plc::machine() {
  parts_->os.quiet().forget();
  return parts_->os.machine();
}
const Machine& Plc::machine() const { return parts_->os.machine(); }
const Surroundings& Plc::surroundings() const { return std::as_const(parts_->os).surroundings(); }
const OperatingSystem& Plc::operatingSystem() const { return parts_->os; }

}  // namespace merker::sinumerik
