#include "station/station.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "station/line_counts.h"
#include "station/parts.h"
#include "system/szl.h"

namespace merker::station {
namespace {

std::string placeText(const cpu::Place& place, const block::Program& program) {
  if (!place.known) return {};
  std::string text = fmt::format(", {} byte {}", toString(place.block), place.offset);
  const auto found = program.find(place.block);
  if (found == program.end() || place.replaced) return text;
  const block::Block& block = found->second;
  const std::uint32_t line = block.line(place.offset);
  if (line != 0) text += fmt::format(" ({}:{})", block.file, line);
  return text;
}

}  // namespace

Station::Station(Options options) : parts_(std::make_unique<Parts>(std::move(options))) {
  parts_->self = this;
}
Station::~Station() = default;

Station::Station(Station&& other) noexcept : parts_(std::move(other.parts_)) {
  parts_->self = this;
}
Station& Station::operator=(Station&& other) noexcept {
  parts_ = std::move(other.parts_);
  if (parts_) parts_->self = this;
  return *this;
}

// Whoever gets at the CPU, its modules or its plants may change them.
cpu::Cpu& Station::cpu() {
  parts_->cpu.quiet().forget();
  return parts_->cpu;
}
system::SzlList Station::systemStatus(std::uint32_t list, std::uint32_t index) {
  return system::readSzl({parts_->cpu, parts_->modules.get(), &communication()}, list, index);
}
const cpu::Cpu& Station::cpu() const { return parts_->cpu; }
system::Alarms& Station::alarms() { return parts_->services.alarms(); }
system::Communication& Station::communication() { return parts_->services.communication(); }
system::Connections& Station::connections() { return parts_->services.connections(); }
system::SendReceive& Station::sendReceive() { return parts_->services.sendReceive(); }

const CpuModel& Station::model() const { return *parts_->model; }
const block::Program& Station::program() const { return *parts_->program; }
std::shared_ptr<const block::Program> Station::loaded() const { return parts_->program; }

bool Station::setEngine(Engine engine) {
  const bool compiled = engine == Engine::Compiled;
  if (parts_->partner) parts_->partner->setEngine(engine);
  if (compiled && !MixedEngine::canCompile()) return false;
  parts_->engine.compile(compiled, parts_->cpu);
  return true;
}
bool Station::setEngine(Engine engine, const Translations& made) {
  if (made.compiled() != (engine == Engine::Compiled)) return false;
  parts_->engine.exchange(made, parts_->cpu);
  return true;
}
bool Station::setCompiled(bool on) {
  return setEngine(on ? Engine::Compiled : Engine::Interpreter);
}
void Station::compileWhenItPays(bool elsewhere) {
  if (parts_->partner) parts_->partner->compileWhenItPays(elsewhere);
  parts_->engine.compileWhenItPays(parts_->cpu, elsewhere);
}
void Station::supply(std::shared_ptr<Translations> made) { parts_->engine.supply(std::move(made)); }
Engine Station::engine() const {
  return parts_->engine.compiles() ? Engine::Compiled : Engine::Interpreter;
}
std::size_t Station::compiledBytes() const { return parts_->engine.compiledBytes(parts_->cpu); }

Mode Station::mode() const {
  switch (parts_->cpu.mode()) {
    case cpu::Mode::Stop:
      return Mode::Stop;
    case cpu::Mode::Startup:
      return Mode::Startup;
    case cpu::Mode::Run:
      return Mode::Run;
    case cpu::Mode::Halt:
      return Mode::Halt;
  }
  return Mode::Stop;
}

bool Station::stoppedByFault() const {
  return mode() == Mode::Stop && parts_->cpu.state().stoppedByFault();
}

std::string Station::stopReason() const {
  if (mode() != Mode::Stop) return {};
  if (!powered()) return "the CPU is switched off";
  const cpu::DiagnosticEvent& event = parts_->cpu.state().stopEvent();
  if (event.text.empty()) return {};
  return fmt::format("{}{} [16#{:04X}]", event.text, placeText(event.place, program()),
                     event.event);
}

void Station::setSwitch(cpu::SwitchPosition position) { parts_->cpu.turnSwitch(position); }
cpu::SwitchPosition Station::switchPosition() const { return parts_->cpu.modeSwitch().position(); }
cpu::Leds Station::leds() const {
  return parts_->services.communication().seen(parts_->cpu.leds());
}
void Station::memoryReset() { parts_->cpu.memoryReset(); }
bool Station::warmRestart() { return parts_->restart(cpu::Restart::ManualWarm); }
bool Station::hasHotRestart() const { return model().hotRestart; }
bool Station::hotRestart() { return parts_->restart(cpu::Restart::ManualHot); }
bool Station::coldRestart() { return parts_->restart(cpu::Restart::ManualCold); }
bool Station::powered() const { return parts_->cpu.powered(); }
void Station::stop() { parts_->cpu.turnSwitch(cpu::SwitchPosition::Stop); }
bool Station::halt() { return parts_->cpu.halt(); }
bool Station::resume() { return parts_->cpu.resume(); }
void Station::powerOff() { parts_->cpu.powerOff(); }
void Station::powerOn(bool buffered) { parts_->cpu.powerOn(buffered); }
void Station::setBattery(bool low) { parts_->cpu.moduleEvents().setBattery(low); }
bool Station::batteryFails(bool fails) {
  setBattery(fails);
  return true;
}
void Station::removeCard() { parts_->cpu.requestMemoryReset(); }
void Station::trigger(const cpu::Trigger& event) { cpu::trigger(parts_->cpu, event); }
void Station::retentive(block::RetentiveData& data) const { parts_->cpu.retentive(data); }
void Station::restore(const block::RetentiveData& data) { parts_->cpu.restore(data); }

const block::RetentiveData& Station::kept() {
  retentive(parts_->kept);
  return parts_->kept;
}

// In STOP, or after a change of the program: a manual restart.
bool Station::switchOn(const block::RetentiveData& data, const controller::Renewal&) {
  restore(data);
  powerOn();
  if (mode() == Mode::Stop) warmRestart();
  return true;
}

void Station::take(const cpu::Snapshot& from, std::shared_ptr<const block::Program> program) {
  parts_->program = program;
  parts_->cpu.take(from, std::move(program));
  if (parts_->periphery) parts_->periphery->deliverAll(parts_->cpu, from.inputs);
}

Instant Station::now() const { return parts_->cpu.machine().clock; }
std::uint64_t Station::cycles() const { return parts_->cpu.cycle().count(); }
std::uint64_t Station::instructions() const { return parts_->cpu.machine().instructions; }

bool Station::settle(Duration longest) {
  cpu::Cpu& cpu = parts_->cpu;
  const Instant latest = now() + longest;
  const auto ended = [&cpu] { return cpu.betweenCycles() || !cpu::executes(cpu.mode()); };
  while (!ended() && now() < latest) parts_->step(latest);
  parts_->takeAlong();
  return ended();
}

void Station::moveTo(Instant t) {
  while (now() < t) {
    passQuietCycles(t, Instant::never());
    if (now() < t) parts_->step(t);
  }
  if (!powered() && parts_->periphery) parts_->periphery->goOn(now());
}

void Station::advanceTo(Instant t) {
  moveTo(t);
  parts_->takeAlong();
}

bool Station::advanceToCheckpoint(Instant limit) {
  cpu::Cpu& cpu = parts_->cpu;
  const std::uint64_t before = cpu.cycle().checkpoints();
  while (now() < limit && cpu.cycle().checkpoints() == before) parts_->step(limit);
  if (!powered() && parts_->periphery) parts_->periphery->goOn(now());
  parts_->takeAlong();
  return cpu.cycle().checkpoints() != before;
}

void Station::advanceCycles(std::uint64_t count) {
  cpu::Cpu& cpu = parts_->cpu;
  for (; count > 0 && cpu::executes(cpu.mode()); --count) {
    if (nobodyLooks()) count -= cpu.passQuiet({.most = count});
    if (count == 0) break;
    const std::uint64_t before = cycles();
    const Instant latest = now() + kLongestCycle;
    while (cycles() == before && cpu::executes(cpu.mode()) && now() < latest) parts_->step(latest);
    if (cycles() == before) break;  // STOP, or a startup OB that does not end
    settle();
  }
  parts_->takeAlong();
}

bool Station::runOb1(Duration most) { return parts_->cpu.runOb1(most); }

io::Rack* Station::rack() {
  if (!parts_->periphery) return nullptr;
  parts_->cpu.quiet().forget();
  parts_->periphery->refresh(now());
  return &parts_->periphery->rack();
}
const io::Rack* Station::rack() const {
  return parts_->periphery ? &parts_->periphery->rack() : nullptr;
}

plant::Plants* Station::plants() {
  parts_->cpu.quiet().forget();
  return parts_->periphery ? &parts_->periphery->plants() : nullptr;
}
const plant::Plants* Station::plants() const {
  return parts_->periphery ? &parts_->periphery->plants() : nullptr;
}

const positioning::Channel* Station::axis() const {
  return parts_->periphery ? std::as_const(*parts_->periphery).positioning().channel() : nullptr;
}

// With the diagnostic interrupt the CPU is told at its next instruction boundary.
serial::Coupling* Station::serial() {
  serial::Coupling* coupling = parts_->serial();
  if (coupling == nullptr) return nullptr;
  parts_->cpu.quiet().forget();
  coupling->advance(now());
  parts_->cpu.machine().interrupt();
  return coupling;
}

const std::vector<DiagnosticEntry>& Station::diagnostics() const {
  Parts& p = *parts_;
  const cpu::Diagnostics& buffer = p.cpu.diagnostics();
  if (p.diagnosticsSeen == buffer.added()) return p.diagnostics;
  p.diagnosticsSeen = buffer.added();
  p.diagnostics.clear();
  for (const cpu::DiagnosticEvent& event : buffer.events())
    p.diagnostics.push_back(
        {event.event, event.time, event.text + placeText(event.place, *p.program)});
  return p.diagnostics;
}

const std::vector<CheckResult>& Station::checkResults() const {
  Parts& p = *parts_;
  p.checks.clear();
  for (const block::CheckRecord& record : p.engine.interpreter().checkRecords())
    p.checks.push_back(record.result());
  return p.checks;
}

std::map<BlockId, std::map<std::uint32_t, std::uint64_t>> Station::executed() const {
  return parts_->engine.interpreter().executed();
}

std::string Station::modelName() const { return std::string(model().name); }
bool Station::hasColdRestart() const { return model().coldRestart; }

controller::ExecutedLines Station::executedLines() const {
  return lineCounts(program(), executed());
}

bool Station::mayRead(std::string_view password) const {
  const CpuParameters& parameters = parts_->cpu.parameters();
  return parameters.protection < 3 || password == parameters.password;
}

bool Station::mayWrite(std::string_view password) const {
  const CpuParameters& parameters = parts_->cpu.parameters();
  return switchPosition() != cpu::SwitchPosition::Run &&
         (parameters.protection < 2 || password == parameters.password);
}

std::string Station::download(std::shared_ptr<const block::Program> program,
                              std::string_view password) {
  if (switchPosition() == cpu::SwitchPosition::Run)
    return "the mode switch is at RUN; blocks can be loaded in RUN-P and STOP only";
  if (!mayWrite(password))
    return fmt::format("the CPU is write-protected (protection level {}); the password is needed",
                       parts_->cpu.parameters().protection);
  parts_->program = program;
  parts_->diagnosticsSeen = 0;  // places have other lines
  parts_->cpu.download(std::move(program));
  return {};
}

std::string Station::copyRamToRom(std::string_view password) {
  if (mode() != Mode::Stop) return "values are copied to load memory in STOP only";
  auto program = std::make_shared<block::Program>(*parts_->program);
  for (auto& [id, block] : *program) {
    if (id.kind != BlockKind::DB) continue;
    const cpu::DataBlock* data = parts_->cpu.machine().dataBlocks.find(id.number);
    if (data != nullptr && !data->madeByProgram) block.actualData = data->data;
  }
  return download(std::move(program), password);
}

void Station::onCycle(std::function<void(controller::Controller&)> observer) {
  parts_->eachCycle = observer != nullptr;
  parts_->observer = std::move(observer);
  parts_->cpu.onCheckpoint([parts = parts_.get()] { parts->checkpoint(); });
}

void Station::onChange(std::function<void(controller::Controller&)> observer) {
  onCycle(std::move(observer));
  parts_->eachCycle = false;
}

// Of two stations at one line each takes the other along; partners on a subnet are served at each
// checkpoint, if there is anything to serve.
bool Station::nobodyLooks() const {
  const serial::Coupling* const line = parts_->serial();
  return !parts_->eachCycle && !(parts_->onSubnet() && parts_->maySend()) &&
         (line == nullptr || !line->joined());
}

void Station::passQuietCycles(Instant limit, Instant enough) {
  if (nobodyLooks()) parts_->cpu.passQuiet({.limit = limit, .enough = enough});
}

void Station::join(network::Node& node, const network::GlobalData& globalData) {
  parts_->services.partners().join(node, connectionLimits(model()).basic);
  parts_->globalData = system::GlobalDataExchange(globalData);
  parts_->cpu.onCheckpoint([parts = parts_.get()] { parts->checkpoint(); });
}

void Station::joinDp(network::Node& node) { parts_->periphery->dp().join(node); }

void Station::joinWires(network::Node& node, std::size_t partner, bool plant) {
  parts_->periphery->joinWires(parts_->cpu, node, partner, plant);
}

bool Station::maySend() const { return parts_->maySend(); }

void Station::connect(const network::ConnectionEnd& end) {
  system::Services& services = parts_->services;
  if (end.kind == ConnectionKind::S7)
    parts_->links.add(end, services.communication().parameters.pdu, services.connections(),
                      services.partners());
  else
    parts_->links.add(end, services.sendReceive());
  parts_->cpu.onCheckpoint([parts = parts_.get()] { parts->checkpoint(); });
}

}  // namespace merker::station
