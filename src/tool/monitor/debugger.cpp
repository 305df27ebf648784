#include "monitor/debugger.h"

#include <algorithm>
#include <functional>
#include <set>

namespace merker::monitor {

using controller::Mode;

namespace {

// How far time moves before somebody may interrupt.
constexpr Duration kPortion = Duration::milliseconds(100);

}  // namespace

Debugger::Debugger(Target& target) : target_(target) {}

Debugger::~Debugger() { target_.removeProbes(); }

void Debugger::place() {
  std::set<BlockId> looked;
  for (const Breakpoint& one : breakpoints_)
    if (one.enabled) looked.insert(one.place.block);
  for (const ProgramStatus& one : statuses_) looked.insert(one.code().id());
  std::erase_if(watchers_, [](const auto& one) { return one.expired(); });
  for (const auto& one : watchers_)
    if (const auto watcher = one.lock(); watcher && watcher->wanted())
      looked.insert(watcher->watched);
  target_.probe([&](BlockId id) { return step_ || looked.contains(id); }, *this);
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

bool Debugger::before(Spot& spot) {
  tellStatuses(spot, &ProgramStatus::arrived);
  const At here{spot.code.id(), spot.identity, spot.offset, spot.depth.frames};
  const bool leaving = leaveFrom_ == here;
  if (leaving) leaveFrom_.reset();
  Breakpoint* stop = leaving ? nullptr : breakpointAt(spot.code.id(), spot.offset);
  if (stop != nullptr && !stop->enabled) stop = nullptr;
  const bool stepped = !leaving && step_ && stepEnds(spot);
  if ((stop != nullptr || stepped) && holdAt(spot, here, stop)) return true;
  tellStatuses(spot, &ProgramStatus::before);
  tellWatchers(spot, &InstructionWatcher::before);
  return false;
}

bool Debugger::holdAt(Spot& spot, const At& here, Breakpoint* stop) {
  if (!spot.hold()) return false;
  if (stop != nullptr) ++stop->hits;
  heldAt_ = here;
  pause_.why = stop != nullptr ? Pause::Why::Breakpoint : Pause::Why::Step;
  pause_.breakpoint = stop != nullptr ? stop->number : 0;
  return true;
}

void Debugger::after(const Spot& spot) {
  tellStatuses(spot, &ProgramStatus::after);
  tellWatchers(spot, &InstructionWatcher::after);
  // The OB has ended: what runs next is as good as the caller.
  if (step_ && spot.levelEnded && spot.depth.levels <= step_->depth.levels)
    step_->kind = StepKind::Into;
}

// A step does not end in an interrupt that came between, except in the error OB of its own error.
bool Debugger::stepEnds(const Spot& spot) const {
  if (step_->kind == StepKind::Instruction) return true;
  if (spot.depth.levels > step_->depth.levels && !spot.errorLevel) return false;
  if (!beginsStatement(spot.code, spot.offset) && !endsBlock(spot.code, spot.offset)) return false;
  if (step_->kind == StepKind::Over) return spot.depth.frames <= step_->depth.frames;
  if (step_->kind == StepKind::Out) return spot.depth.frames < step_->depth.frames;
  return true;
}

Pause Debugger::run(Instant limit, const std::function<bool()>& interrupted) {
  step_.reset();
  place();
  return advance(limit, interrupted);
}

void Debugger::setStep(StepKind kind) {
  Depth depth = target_.depth();
  const bool between = depth.levels == 0;
  depth.levels = std::max<std::size_t>(depth.levels, 1);
  step_ = Step{between ? StepKind::Into : kind, depth};
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
  if (step_ && executing()) target_.stepGivenUp();
  step_.reset();
  place();
}

void Debugger::goOn() {
  pause_ = {};
  const bool leaves = target_.plc().mode() == Mode::Halt;
  leaveFrom_ = leaves ? heldAt_ : std::nullopt;
  if (leaves) target_.resume(step_.has_value());
}

bool Debugger::executing() const {
  const Mode mode = target_.plc().mode();
  return mode == Mode::Run || mode == Mode::Startup;
}

Pause Debugger::reason() const {
  const Mode mode = target_.plc().mode();
  if (mode == Mode::Stop) return {Pause::Why::Stop, 0};
  return mode == Mode::Halt ? pause_ : Pause{};
}

Pause Debugger::advance(Instant limit, const std::function<bool()>& interrupted) {
  goOn();
  return proceed(limit, interrupted);
}

Pause Debugger::proceed(Instant limit, const std::function<bool()>& interrupted) {
  const controller::Controller& plc = target_.plc();
  while (executing() && plc.now() < limit) {
    const Instant portion = std::min(limit, plc.now() + kPortion);
    target_.run(portion);
    if (executing() && interrupted && interrupted()) return {Pause::Why::Interrupted, 0};
  }
  return reason();
}

Pause Debugger::runToCheckpoint(Instant limit) {
  step_.reset();
  place();
  goOn();
  if (executing()) target_.runToCheckpoint(limit);
  return reason();
}

std::optional<SourcePlace> Debugger::position() const { return target_.position(); }

const ProgramStatus* Debugger::status(BlockId block, CallEnvironment environment) const {
  const auto found =
      std::ranges::find(statuses_, StatusWish{block, environment}, &ProgramStatus::wish);
  return found == statuses_.end() ? nullptr : &*found;
}

bool Debugger::showStatus(BlockId block, CallEnvironment environment) {
  const auto code = target_.program().find(block);
  if (!code || code->length() == 0) return false;
  statuses_.clear();
  return addStatus(block, environment);
}

bool Debugger::addStatus(BlockId block, CallEnvironment environment,
                         std::vector<CallValues> values) {
  const auto code = target_.program().find(block);
  if (!code || code->length() == 0) return false;
  if (status(block, environment) == nullptr)
    statuses_.emplace_back(*code, environment, std::move(values));
  place();
  return true;
}

void Debugger::watch(const std::shared_ptr<InstructionWatcher>& watcher) {
  watchers_.push_back(watcher);
  place();
}

void Debugger::tellStatuses(const Spot& spot, void (ProgramStatus::*what)(const Spot&)) {
  for (ProgramStatus& one : statuses_)
    if (one.code().id() == spot.code.id()) (one.*what)(spot);
}

void Debugger::tellWatchers(const Spot& spot, void (InstructionWatcher::*what)(const Spot&)) {
  for (const auto& one : watchers_)
    if (const auto watcher = one.lock(); watcher && watcher->watched == spot.code.id())
      ((*watcher).*what)(spot);
}

void Debugger::hideStatus() {
  keepStatus([](const auto&) { return false; });
}

void Debugger::keepStatus(const std::function<bool(const ProgramStatus&)>& wanted) {
  std::erase_if(statuses_, [&](const ProgramStatus& one) { return !wanted(one); });
  place();
}

}  // namespace merker::monitor
