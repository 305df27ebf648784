#include "control/cnc.h"

#include <algorithm>
#include <utility>

#include "control/buffered.h"
#include "control/compiled_code.h"
#include "control/fault.h"
#include "control/plc_options.h"
#include "control/reference.h"
#include "nc/datum.h"
#include "plc/line_counts.h"

namespace merker::cnc {

using controller::Mode;

struct Cnc::Parts {
  explicit Parts(Options given) : options(std::move(given)) { build(); }

  // The PLC points to macros and engine: they are made first and go last.
  void build() {
    plc.reset();
    macros = std::make_unique<nc::FunctionMacros>(options.macros);
    macros->control() = options.control;
    sinumerik::Options plcPart = plcOptions(options);
    plcPart.macros = macros.get();
    engine = std::make_unique<CompiledCode>();
    engine->on = options.compiled && canCompile();
    plcPart.engine = engine.get();
    plc = std::make_unique<sinumerik::Plc>(plcPart);
    macros->control().machineData[kSamplingDatum] = plc->machineData().samplingCode;
  }

  // MD 155 is one datum: what the program wrote with FB 62 holds from the next start on.
  void takeSamplingCode() {
    const std::int32_t code = macros->control().machineData[kSamplingDatum];
    plc->machineData().samplingCode = static_cast<std::uint8_t>(std::clamp(code, 0, 255));
  }

  void showAlarms() {
    const nc::Control& control = macros->control();
    sinumerik::NcSide nc = control.signals;
    nc.alarm = !control.alarms.empty();
    nc.machiningStop = nc.alarm && control.machiningStop;
    if (nc != std::as_const(*plc).surroundings().nc) plc->surroundings().nc = nc;
  }

  Options options;
  std::unique_ptr<Cnc> partner;
  bool partnerStands = false;  // because this control is in HALT
  std::shared_ptr<nc::CouplingArea> area;
  std::unique_ptr<nc::FunctionMacros> macros;
  std::unique_ptr<CompiledCode> engine;
  std::unique_ptr<sinumerik::Plc> plc;
  Keeper keeper;
  Duration before{};  // what passed before the last memory reset
  std::uint64_t cyclesBefore = 0, instructionsBefore = 0;
  controller::ExecutedLines linesBefore;
  std::function<void(controller::Controller&)> observer;
  bool eachCycle = false;     // the observer wants to see it, also when it changed nothing
  bool passOverQuiet = true;  // as it was wanted
  std::vector<controller::DiagnosticEntry> diagnostics;
  std::vector<controller::CheckResult> checks;
};

namespace {

std::uint32_t lineAt(const mc5::Block& block, std::uint32_t offset) {
  std::uint32_t line = 0;
  for (const mc5::LineEntry& entry : block.lines)
    if (entry.offset <= offset) line = entry.line;
  return line;
}

}  // namespace

Cnc::Cnc(Options options) : parts_(std::make_unique<Parts>(std::move(options))) { watch(); }
Cnc::~Cnc() = default;

sinumerik::Plc& Cnc::plc() { return *parts_->plc; }
const sinumerik::Plc& Cnc::plc() const { return *parts_->plc; }
nc::Control& Cnc::control() { return parts_->macros->control(); }

void Cnc::couple(std::unique_ptr<Cnc> partner, nc::Side side) {
  Parts& p = *parts_;
  p.partner = std::move(partner);
  p.area = p.partner->parts_->area = std::make_shared<nc::CouplingArea>();
  p.options.coupling.emplace().side = side;
  connect();
}

// The partner is never ahead of this control when it looks at the area.
void Cnc::connect() {
  Parts& p = *parts_;
  decideOnQuietCycles();
  if (!p.partner) return;
  p.partner->decideOnQuietCycles();
  const nc::Side side = p.options.coupling->side;
  const bool master = side == nc::Side::Master;
  p.macros->couple(p.area, side, [this] { meet(); });
  p.partner->parts_->macros->couple(p.area, master ? nc::Side::Control : nc::Side::Master);
}

void Cnc::meet() {
  if (!parts_->partner || !parts_->plc) return;
  standTogether();
  parts_->partner->advanceTo(now());
  if (parts_->partner->mode() == Mode::Halt && !parts_->partnerStands) plc().holdNext();
}

// The partner comes to where this control went to HALT, and stands there until it continues.
void Cnc::standTogether() {
  Cnc& partner = *parts_->partner;
  const auto since = plc().heldSince();
  if (since && partner.mode() != Mode::Halt) {
    partner.advanceTo(*since + parts_->before);
    parts_->partnerStands = partner.hold();
  }
  if (!since && parts_->partnerStands) partner.resume();
  if (!since) parts_->partnerStands = false;
}

bool Cnc::hold() {
  const bool held = plc().hold();
  meet();
  return held;
}

bool Cnc::resume() {
  if (!plc().resume()) return false;
  if (parts_->partner) parts_->partner->resume();
  parts_->partnerStands = false;
  return true;
}

void Cnc::runTo(Instant t) {
  plc().runTo(Instant{t.ns - parts_->before.ns});
  meet();
}

void Cnc::runToCheckpoint(Instant t) {
  plc().runToCheckpoint(Instant{t.ns - parts_->before.ns});
  meet();
}

nc::CouplingArea* Cnc::couplingArea() { return parts_->area.get(); }
controller::Controller* Cnc::partner() { return parts_->partner.get(); }

std::string Cnc::fault(std::string_view subject, std::string_view kind, bool on) {
  return setFault(*this, subject, kind, on);
}

bool Cnc::batteryFails(bool fails) {
  plc().surroundings().batteryGood = !fails;
  return true;
}

bool Cnc::canCompile() { return jit::available(); }
bool Cnc::setCompiled(bool on) {
  if (parts_->partner) parts_->partner->setCompiled(on);
  parts_->options.compiled = on;
  parts_->engine->payback.end();
  parts_->engine->on = on && canCompile();
  return compiled() == on;
}
// Translation is part of its own thread: in real time it is left to whoever asks for it.
void Cnc::compileWhenItPays(bool elsewhere) {
  constexpr std::uint64_t kPrice = 100'000;  // docs/performance.md, "When code is compiled"
  if (parts_->partner) parts_->partner->compileWhenItPays(elsewhere);
  if (!elsewhere && canCompile() && !compiled()) parts_->engine->payback.begin(kPrice);
}
bool Cnc::compiled() const { return parts_->engine->on; }
void Cnc::translateNow() {
  if (compiled()) plc().translate();
}
std::size_t Cnc::compiledBytes() const { return compiled() ? parts_->engine->bytes() : 0; }
bool Cnc::runOb1(Duration most) { return plc().runOb1(most); }

std::string Cnc::modelName() const { return std::string(parts_->options.model->name); }

bool Cnc::start() { return coldRestart(); }
bool Cnc::warmRestart() {
  parts_->takeSamplingCode();
  return plc().warmStart();
}
bool Cnc::coldRestart() {
  parts_->takeSamplingCode();
  return plc().coldStart();
}
bool Cnc::startFailed() const { return stoppedByFault() || mode() == Mode::Startup; }
void Cnc::stop() { plc().stop(); }
void Cnc::powerOff() { plc().powerOff(); }
void Cnc::powerOn(bool buffered) {
  if (powered()) return;
  const bool kept = buffered && plc().surroundings().batteryGood;
  if (!kept) nc::forgetBuffered(control());
  parts_->takeSamplingCode();
  plc().powerOn(kept);
}

const block::RetentiveData& Cnc::kept() { return parts_->keeper.look(*this); }

bool Cnc::switchOn(const block::RetentiveData& data, const controller::Renewal& renewal) {
  memoryReset();
  const nc::Control configured = control();
  if (!restore(*this, data)) return false;
  if (renewal.anotherConfiguration) control() = configured;
  const mc5::Program& program = plc().program();
  for (const BlockId id : renewal.loaded) plc().programmer().load(program.at(blockOf(id)));
  for (const BlockId id : renewal.deleted) plc().programmer().erase(blockOf(id));
  powerOn(true);
  return true;
}

void Cnc::memoryReset() {
  Parts& p = *parts_;
  p.before = Duration{now().ns};
  p.cyclesBefore = cycles();
  p.instructionsBefore = instructions();
  p.linesBefore = executedLines();
  if (p.area) *p.area = {};
  const sinumerik::PlacedProbes probes = plc().probes();
  p.build();
  p.partnerStands = false;
  for (const auto& [block, probe] : probes) plc().probe(block, probe);
  watch();
  if (!p.partner) return;
  p.partner->memoryReset();
  connect();
  p.partner->start();
}

Instant Cnc::now() const { return plc().now() + parts_->before; }
std::uint64_t Cnc::cycles() const { return parts_->cyclesBefore + plc().cycles(); }
std::uint64_t Cnc::instructions() const {
  return parts_->instructionsBefore + plc().instructions();
}
void Cnc::advanceTo(Instant t) {
  plc().advanceTo(Instant{t.ns - parts_->before.ns});
  meet();
}
// The partner, too: values of both are looked at behind a cycle.
bool Cnc::settle(Duration longest) {
  const bool ended = plc().settle(longest);
  meet();
  return (!parts_->partner || parts_->partner->settle(longest)) && ended;
}
void Cnc::advanceCycles(std::uint64_t count) {
  plc().advanceCycles(count);
  meet();
}
bool Cnc::advanceToCheckpoint(Instant limit) {
  const bool reached = plc().advanceToCheckpoint(Instant{limit.ns - parts_->before.ns});
  meet();
  return reached;
}

void Cnc::onCycle(std::function<void(controller::Controller&)> observer) {
  parts_->eachCycle = observer != nullptr;
  parts_->observer = std::move(observer);
  decideOnQuietCycles();
}
void Cnc::onChange(std::function<void(controller::Controller&)> observer) {
  parts_->observer = std::move(observer);
  parts_->eachCycle = false;
  decideOnQuietCycles();
}

// A coupled control is taken along at each checkpoint.
void Cnc::decideOnQuietCycles() {
  plc().passOverQuietCycles(parts_->passOverQuiet && !parts_->eachCycle && !parts_->area);
}
void Cnc::passOverQuietCycles(bool on) {
  parts_->passOverQuiet = on;
  if (parts_->partner) parts_->partner->passOverQuietCycles(on);
  decideOnQuietCycles();
}
void Cnc::passQuietCycles(Instant limit, Instant enough) {
  plc().passQuietCycles(Instant{std::min(limit, enough).ns - parts_->before.ns});
}

// At the end of each cycle the PLC learns of the NC's alarms; the next one begins with M 24.0 and
// M 24.3 (S5-FLAG-11).
void Cnc::watch() {
  parts_->showAlarms();
  decideOnQuietCycles();
  plc().onCycle([this](sinumerik::Plc&) {
    parts_->showAlarms();
    meet();
    if (parts_->observer) parts_->observer(*this);
  });
}

namespace {

// The reference as the partner itself would have it.
address::Reference own(address::Reference reference) {
  reference.partner = false;
  return reference;
}

}  // namespace

std::optional<std::uint32_t> Cnc::read(const address::Reference& reference) const {
  if (reference.partner)
    return parts_->partner ? parts_->partner->read(own(reference)) : std::nullopt;
  return reference.nc != 0 ? std::nullopt : plc().read(reference);
}

bool Cnc::write(const address::Reference& reference, std::uint32_t value) {
  if (reference.partner) return parts_->partner && parts_->partner->write(own(reference), value);
  const bool owned = !sinumerik::whySystemOwned(plc().operatingSystem(), reference).empty();
  return reference.nc == 0 && !owned && plc().write(reference, value);
}

bool Cnc::force(const address::Reference& reference, std::uint32_t value) {
  if (reference.partner) return parts_->partner && parts_->partner->force(own(reference), value);
  return reference.nc == 0 && plc().force(reference, value);
}

bool Cnc::forced() const {
  return plc().operatingSystem().forces().any() || (parts_->partner && parts_->partner->forced());
}

void Cnc::unforce() {
  plc().unforce();
  if (parts_->partner) parts_->partner->unforce();
}

std::optional<std::vector<std::uint8_t>> Cnc::readBytes(const address::Reference& reference) const {
  if (reference.partner)
    return parts_->partner ? parts_->partner->readBytes(own(reference)) : std::nullopt;
  if (reference.nc == 0) return std::nullopt;
  const std::string digits = nc::readDatum(parts_->macros->control(), nc::unpack(reference.nc));
  return std::vector<std::uint8_t>(digits.begin(), digits.end());
}

bool Cnc::writeBytes(const address::Reference& reference, std::span<const std::uint8_t> digits) {
  if (reference.partner)
    return parts_->partner && parts_->partner->writeBytes(own(reference), digits);
  if (reference.nc == 0) return false;
  const auto number = nc::parseDecimal(std::string(digits.begin(), digits.end()));
  if (!number || !nc::writeDatum(control(), nc::unpack(reference.nc), *number)) return false;
  parts_->showAlarms();
  return true;
}

std::string Cnc::whyRefused(const address::Reference& reference) const {
  if (reference.nc != 0) return nc::whatItTakes(nc::unpack(reference.nc));
  if (reference.partner && parts_->partner) return parts_->partner->whyRefused(own(reference));
  return sinumerik::whyRefused(plc().operatingSystem(), reference);
}

bool Cnc::takes(const address::Reference& datum, std::string_view digits) const {
  if (datum.partner) return parts_->partner && parts_->partner->takes(own(datum), digits);
  return nc::takes(parts_->macros->control(), nc::unpack(datum.nc), digits);
}

std::string Cnc::whyMissing(const address::Reference& reference) const {
  if (reference.partner && parts_->partner) return parts_->partner->whyMissing(own(reference));
  return sinumerik::whyMissing(plc().operatingSystem(), reference);
}

const std::vector<controller::DiagnosticEntry>& Cnc::diagnostics() const {
  Parts& p = *parts_;
  p.diagnostics.clear();
  for (const sinumerik::DiagnosticEntry& entry : plc().diagnostics())
    p.diagnostics.push_back(
        {static_cast<std::uint16_t>(entry.number), entry.time + p.before, entry.text});
  return p.diagnostics;
}

const std::vector<controller::CheckResult>& Cnc::checkResults() const {
  Parts& p = *parts_;
  p.checks = plc().checkResults();
  for (controller::CheckResult& result : p.checks)
    for (controller::CheckFailure& failure : result.failures)
      failure.time = failure.time + p.before;
  return p.checks;
}

controller::ExecutedLines Cnc::executedLines() const {
  static const controller::Counts kNone;
  controller::ExecutedLines lines = parts_->linesBefore;
  const sinumerik::Executed& executed = plc().executed();
  for (const auto& [id, block] : plc().program()) {
    if (id.type == mc5::BlockType::Db || block.file.empty()) continue;
    const auto counts = executed.find(id);
    const auto at = [&code = block](std::uint32_t offset) { return lineAt(code, offset); };
    controller::addLineCounts(block.lines, at, counts == executed.end() ? kNone : counts->second,
                              lines[block.file]);
  }
  return lines;
}

}  // namespace merker::cnc
