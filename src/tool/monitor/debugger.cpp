#include "monitor/debugger.h"

#include <algorithm>
#include <functional>
#include <set>

#include "cpu/cpu.h"

namespace merker::monitor {
namespace {

// How far time moves before somebody may interrupt.
constexpr Duration kPortion = Duration::milliseconds(100);

}  // namespace

// What the CPU sees of the debugger.
class Debugger::Sight : public cpu::Probe {
 public:
  explicit Sight(Debugger& debugger) : debugger_(debugger) {}
  bool before(cpu::Machine& machine, std::uint32_t offset) override {
    return debugger_.before(machine, offset);
  }
  void after(cpu::Machine& machine, const cpu::Code& code, std::uint32_t offset) override {
    debugger_.after(machine, code, offset);
  }

 private:
  Debugger& debugger_;
};

Debugger::Debugger(station::Station& station)
    : station_(station), sight_(std::make_unique<Sight>(*this)) {}

Debugger::~Debugger() {
  for (const auto& [id, block] : station_.program()) station_.cpu().probe(id, nullptr);
}

void Debugger::place() {
  std::set<BlockId> looked;
  for (const Breakpoint& one : breakpoints_)
    if (one.enabled) looked.insert(one.place.block);
  for (const ProgramStatus& one : statuses_) looked.insert(one.block().id);
  for (const auto& [id, block] : station_.program()) {
    if (block.code.empty()) continue;
    const bool wanted = step_ || looked.contains(id);
    station_.cpu().probe(id, wanted ? sight_.get() : nullptr);
  }
}

const Breakpoint& Debugger::setBreakpoint(const SourcePlace& at) {
  if (Breakpoint* old = breakpointAt(at.block, at.offset)) {
    old->enabled = true;
    place();
    return *old;
  }
  breakpoints_.push_back({.number = nextNumber_++, .place = at, .enabled = true, .hits = 0});
  place();
  return breakpoints_.back();
}

bool Debugger::removeBreakpoint(unsigned number) {
  const bool removed = std::erase_if(breakpoints_, [number](const Breakpoint& one) {
                         return one.number == number;
                       }) > 0;
  place();
  return removed;
}

bool Debugger::enableBreakpoint(unsigned number, bool enabled) {
  bool found = false;
  for (Breakpoint& one : breakpoints_)
    if (one.number == number) one.enabled = enabled, found = true;
  place();
  return found;
}

void Debugger::enableBreakpoints(bool enabled) {
  for (Breakpoint& one : breakpoints_) one.enabled = enabled;
  place();
}

void Debugger::removeBreakpoints() {
  breakpoints_.clear();
  place();
}

Breakpoint* Debugger::breakpointAt(BlockId block, std::uint32_t offset) {
  for (Breakpoint& one : breakpoints_)
    if (one.place.block == block && one.place.offset == offset) return &one;
  return nullptr;
}

bool Debugger::before(cpu::Machine& m, std::uint32_t offset) {
  const BlockId id = m.top->code->source->id;
  ProgramStatus* const shown = statusOf(id);
  if (shown != nullptr) shown->arrived(m);
  const At here{m.top->code, offset, m.frames.size()};
  const bool leaving = leaveFrom_ == here;
  if (leaving) leaveFrom_.reset();
  Breakpoint* stop = leaving ? nullptr : breakpointAt(id, offset);
  if (stop != nullptr && !stop->enabled) stop = nullptr;
  const bool stepped = !leaving && step_ && stepEnds(m, offset);
  if ((stop != nullptr || stepped) && m.cpu->halt()) {
    if (stop != nullptr) ++stop->hits;
    leaveFrom_ = here;
    pause_.why = stop != nullptr ? Pause::Why::Breakpoint : Pause::Why::Step;
    pause_.breakpoint = stop != nullptr ? stop->number : 0;
    return true;
  }
  if (shown != nullptr) shown->before(m, offset);
  return false;
}

void Debugger::after(cpu::Machine& m, const cpu::Code& code, std::uint32_t offset) {
  if (ProgramStatus* shown = statusOf(code.source->id)) shown->after(m, offset);
  // The OB has ended: what runs next is as good as the caller.
  if (step_ && m.levelEnded && m.levels.size() <= step_->levels) step_->kind = StepKind::Into;
}

// A step does not end in an interrupt that came between, except in the error OB of its own error.
bool Debugger::stepEnds(const cpu::Machine& m, std::uint32_t offset) const {
  if (step_->kind == StepKind::Instruction) return true;
  if (m.levels.size() > step_->levels && !m.levels.back().errorOb) return false;
  const block::Block& block = *m.top->code->source;
  if (!beginsStatement(block, offset) && !endsBlock(block, offset)) return false;
  if (step_->kind == StepKind::Over) return m.frames.size() <= step_->frames;
  if (step_->kind == StepKind::Out) return m.frames.size() < step_->frames;
  return true;
}

Pause Debugger::run(Instant limit, const std::function<bool()>& interrupted) {
  step_.reset();
  place();
  return advance(limit, interrupted);
}

void Debugger::setStep(StepKind kind) {
  const cpu::Machine& m = station_.cpu().machine();
  const bool between = m.levels.empty();
  step_ = Step{between ? StepKind::Into : kind, m.frames.size(),
               std::max<std::size_t>(m.levels.size(), 1)};
  place();
}

Pause Debugger::step(StepKind kind, Instant limit, const std::function<bool()>& interrupted) {
  setStep(kind);
  const Pause result = advance(limit, interrupted);
  giveUpStep();
  return result;
}

Pause Debugger::beginStep(StepKind kind, Instant limit) {
  setStep(kind);
  goOn();
  return stepOn(limit);
}

Pause Debugger::stepOn(Instant limit) {
  const Pause result = proceed(limit, {});
  if (!executing()) giveUpStep();
  return result;
}

void Debugger::giveUpStep() {
  step_.reset();
  place();
}

void Debugger::goOn() {
  cpu::Cpu& cpu = station_.cpu();
  pause_ = {};
  if (cpu.mode() == cpu::Mode::Halt)
    cpu.resume();
  else
    leaveFrom_.reset();
}

bool Debugger::executing() const {
  const cpu::Mode mode = station_.cpu().mode();
  return mode == cpu::Mode::Run || mode == cpu::Mode::Startup;
}

Pause Debugger::reason() const {
  const cpu::Mode mode = station_.cpu().mode();
  if (mode == cpu::Mode::Stop) return {Pause::Why::Stop, 0};
  return mode == cpu::Mode::Halt ? pause_ : Pause{};
}

Pause Debugger::advance(Instant limit, const std::function<bool()>& interrupted) {
  goOn();
  return proceed(limit, interrupted);
}

Pause Debugger::proceed(Instant limit, const std::function<bool()>& interrupted) {
  cpu::Cpu& cpu = station_.cpu();
  while (executing() && station_.now() < limit) {
    const Instant portion = std::min(limit, station_.now() + kPortion);
    while (executing() && station_.now() < portion) cpu.step(portion);
    if (executing() && interrupted && interrupted()) return {Pause::Why::Interrupted, 0};
  }
  return reason();
}

Pause Debugger::runToCheckpoint(Instant limit) {
  cpu::Cpu& cpu = station_.cpu();
  step_.reset();
  place();
  goOn();
  const std::uint64_t before = cpu.checkpoints();
  while (executing() && station_.now() < limit && cpu.checkpoints() == before) cpu.step(limit);
  return reason();
}

std::optional<SourcePlace> Debugger::position() const {
  const cpu::Cpu& cpu = station_.cpu();
  const cpu::Machine& m = cpu.machine();
  if (m.levels.empty() || m.top->code == nullptr) return std::nullopt;
  const std::uint32_t offset = cpu.mode() == cpu::Mode::Stop ? m.position : cpu.offset(*m.top);
  return sourcePlace(*m.top->code->source, offset);
}

ProgramStatus* Debugger::statusOf(BlockId block) {
  for (ProgramStatus& one : statuses_)
    if (one.block().id == block) return &one;
  return nullptr;
}

const ProgramStatus* Debugger::status(BlockId block) const {
  for (const ProgramStatus& one : statuses_)
    if (one.block().id == block) return &one;
  return nullptr;
}

bool Debugger::showStatus(BlockId block, CallEnvironment environment) {
  const auto found = station_.program().find(block);
  if (found == station_.program().end() || found->second.code.empty()) return false;
  statuses_.clear();
  return addStatus(block, environment);
}

bool Debugger::addStatus(BlockId block, CallEnvironment environment) {
  const auto found = station_.program().find(block);
  if (found == station_.program().end() || found->second.code.empty()) return false;
  if (statusOf(block) == nullptr) statuses_.emplace_back(found->second, environment);
  place();
  return true;
}

void Debugger::hideStatus() {
  statuses_.clear();
  place();
}

}  // namespace merker::monitor
