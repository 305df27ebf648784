#include "monitor/monitor.h"

#include <algorithm>

#include "base/text.h"
#include "monitor/nowhere.h"
#include "plc/cell_value.h"

namespace merker::monitor {

using simulator::checkForce;
using simulator::checkOnce;
using simulator::overlap;
using simulator::samePlace;

Monitor::Monitor(std::unique_ptr<Target> target, const source::SymbolTable& symbols,
                 simulator::Resolver resolver)
    : target_(std::move(target)),
      symbols_(symbols),
      resolver_(
          [this, global = resolver](std::string_view text, const Position& at) {
            return text.starts_with('#') ? local(text, at) : global(text, at);
          },
          resolver.constants, resolver.ofControl),
      debugger_(*target_) {}

void Monitor::reached(CyclePoint point) {
  if (point == CyclePoint::Stop) debugger_.forgetHalt();
  for (VariableTable& table : tables_) table.reached(point);
  if (observer_) observer_(point);
  std::erase_if(watchers_, [](const auto& one) { return one.expired(); });
  const auto watchers = watchers_;  // one may end itself
  for (const auto& watcher : watchers)
    if (const auto one = watcher.lock()) one->reached(point);
}

LocationContext Monitor::locations(std::string currentFile) const {
  return {program(), symbols_, std::move(currentFile)};
}

Result<address::Reference> Monitor::operand(std::string_view text) const {
  auto reference = resolver_(text, nowhere());
  if (reference && reference->operand.kind != address::OperandKind::Memory)
    reference->operand.width = Width::Word;  // T, Z: what LC loads
  return reference;
}

Result<address::Reference> Monitor::local(std::string_view text, const Position& at) const {
  return makeProblem(ProblemCode::P1216, at, std::string(text));
}

Result<std::string> Monitor::read(std::string_view text, DisplayFormat format) const {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  if (auto problem = checkFormat(*reference, format)) return *problem;
  const auto value = monitor::read(plc(), *reference);
  if (!value) return makeProblem(ProblemCode::P1213, nowhere(), std::string(text));
  return show(*reference, *value, format);
}

bool Monitor::isForced(const address::Reference& reference) const {
  return std::ranges::any_of(forces(),
                             [&](const Forced& one) { return overlap(one.operand, reference); });
}

// A memory reset frees everything; who reset the CPU does not come by here.
const std::vector<Forced>& Monitor::forces() const {
  if (!holdsForces()) forces_.clear();
  return forces_;
}

Problem Monitor::refusal(const address::Reference& reference) const {
  const std::string reason = plc().whyRefused(reference);
  if (reason.empty()) return makeProblem(ProblemCode::P1212, nowhere(), reference.text);
  return makeProblem(ProblemCode::P0988, nowhere(), reference.text, reason);
}

// A forced output or flag stays as it is; a forced input can be set at its terminal, where it
// waits.
std::optional<Problem> Monitor::checkWrite(const address::Reference& reference) const {
  if (reference.operand.area != Area::Input && isForced(reference))
    return makeProblem(ProblemCode::P1217, nowhere(), reference.text);
  if (canWrite(reference)) return std::nullopt;
  if (monitor::read(plc(), reference)) return refusal(reference);
  return makeProblem(ProblemCode::P1213, nowhere(), reference.text);
}

std::optional<Problem> Monitor::checkValue(const address::Reference& reference,
                                           const Value& value) const {
  if (auto problem = checkWrite(reference)) return problem;
  const bool good = controller::isCell(reference)
                        ? controller::isCellValue(reference.operand.kind, value.bits)
                        : takes(reference, value);
  return good ? std::nullopt : std::optional(refusal(reference));
}

Result<Change> Monitor::understand(const Wish& wish) const {
  auto reference = operand(wish.operand);
  if (!reference) return reference.error();
  auto value = parse(*reference, wish.value, wish.format, resolver_.constants);
  if (!value) return value.error();
  return Change{std::move(*reference), std::move(value.value())};
}

Result<Change> Monitor::change(const Wish& wish) const {
  auto result = understand(wish);
  if (!result) return result;
  if (auto problem = checkValue(result->operand, result->value)) return *problem;
  return result;
}

Result<Change> Monitor::inCycle(const Wish& wish) const {
  auto result = change(wish);
  if (result && isForced(result->operand))
    return makeProblem(ProblemCode::P1217, nowhere(), result->operand.text);
  return result;
}

void Monitor::modifyInCycle(const address::Reference& reference, const Value& value) {
  if (!isForced(reference)) writeInCycle(reference, value);
}

std::optional<Problem> Monitor::write(const std::vector<Wish>& wishes) {
  struct Step {
    Change change;
    std::optional<Value> before;
  };
  std::vector<Step> good;
  for (const Wish& wish : wishes) {
    auto one = change(wish);
    if (!one) return one.error();
    auto before = monitor::read(plc(), one->operand);
    good.push_back({std::move(one.value()), std::move(before)});
  }
  for (std::size_t i = 0; i < good.size(); ++i) {
    const auto& [operand, value] = good[i].change;
    if (monitor::write(plc(), operand, value)) continue;
    for (std::size_t j = i; j-- > 0;)
      if (good[j].before) monitor::write(plc(), good[j].change.operand, *good[j].before);
    return refusal(operand);
  }
  return std::nullopt;
}

void Monitor::forceAgain() {
  plc().unforce();
  for (const Forced& one : forces_) plc().force(one.operand, one.value);
}

bool Monitor::isForceable(const address::Reference& reference) const {
  return canForce(reference) && plc().read(reference).has_value();
}

std::optional<Problem> Monitor::force(const std::vector<Wish>& wishes) {
  std::vector<Change> changes;
  for (const Wish& wish : wishes) {
    const auto reference = operand(wish.operand);
    if (!reference) return reference.error();
    if (!isForceable(*reference))
      return makeProblem(ProblemCode::P1211, nowhere(), std::string(wish.operand));
    auto one = understand(wish);
    if (!one) return one.error();
    changes.push_back(std::move(one.value()));
  }
  return force(std::move(changes));
}

std::optional<Problem> Monitor::force(std::vector<Change> changes) {
  std::vector<Forced> good;
  for (Change& one : changes) {
    if (!isForceable(one.operand))
      return makeProblem(ProblemCode::P1211, nowhere(), one.operand.text);
    if (auto problem = checkForce(forces(), one.operand)) return problem;
    if (auto problem = checkOnce(good, one.operand)) return problem;
    good.push_back({std::move(one.operand), one.value.bits});
  }
  for (const Forced& one : good)
    if (!plc().force(one.operand, one.value)) {
      forceAgain();
      return makeProblem(ProblemCode::P1211, nowhere(), one.operand.text);
    }
  for (Forced& one : good) {
    std::erase_if(forces_, [&](const Forced& old) { return samePlace(old.operand, one.operand); });
    forces_.push_back(std::move(one));
  }
  return std::nullopt;
}

std::optional<Problem> Monitor::unforce(const std::vector<std::string_view>& operands) {
  std::vector<Forced> left = forces();
  for (const std::string_view text : operands) {
    const auto reference = operand(text);
    if (!reference) return reference.error();
    const auto removed =
        std::erase_if(left, [&](const Forced& one) { return samePlace(one.operand, *reference); });
    if (removed == 0) return makeProblem(ProblemCode::P1214, nowhere(), std::string(text));
  }
  forces_ = std::move(left);
  forceAgain();
  return std::nullopt;
}

void Monitor::unforceAll() {
  forces_.clear();
  plc().unforce();
}

VariableTable& Monitor::addTable() {
  return tables_.emplace_back(static_cast<CycleAccess&>(*this), resolver_);
}

void Monitor::removeTable(const VariableTable& table) {
  tables_.remove_if([&](const VariableTable& one) { return &one == &table; });
}

}  // namespace merker::monitor
