#include "monitor/monitor.h"

#include <algorithm>

#include "base/text.h"
#include "cpu/cpu.h"

namespace merker::monitor {
namespace {

Position nowhere() { return Position{"", 0, 0, 0}; }

// S7-300: E and A of the process image.
bool canForce(const address::Reference& reference) {
  const address::Operand& operand = reference.operand;
  return operand.kind == address::OperandKind::Memory &&
         (operand.area == Area::Input || operand.area == Area::Output);
}

}  // namespace

Monitor::Monitor(station::Station& station, const source::SymbolTable& symbols,
                 simulator::Resolver resolver)
    : station_(station),
      symbols_(symbols),
      resolver_([this, global = std::move(resolver)](std::string_view text, const Position& at) {
        return text.starts_with('#') ? local(text, at) : global(text, at);
      }),
      debugger_(station) {
  station_.cpu().onCyclePoint([this](cpu::CyclePoint point) {
    for (VariableTable& table : tables_) table.reached(point);
    if (observer_) observer_(point);
  });
}

Monitor::~Monitor() { station_.cpu().onCyclePoint({}); }

LocationContext Monitor::locations(std::string currentFile) const {
  return {station_.program(), symbols_, std::move(currentFile)};
}

Result<address::Reference> Monitor::operand(std::string_view text) const {
  auto reference = resolver_(text, nowhere());
  if (reference && reference->operand.kind != address::OperandKind::Memory)
    reference->operand.width = Width::Word;  // T, Z: what LC loads
  return reference;
}

Result<address::Reference> Monitor::local(std::string_view text, const Position& at) const {
  for (const FrameVariable& one : frameVariables(station_.cpu(), 0, SIZE_MAX))
    if (one.operand && equalsIgnoreCase(one.operand->text, text)) return *one.operand;
  return makeProblem(ProblemCode::P1216, at, std::string(text));
}

Result<std::string> Monitor::read(std::string_view text, DisplayFormat format) const {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  if (auto problem = checkFormat(*reference, format)) return *problem;
  const auto value = monitor::read(station_, *reference);
  if (!value) return makeProblem(ProblemCode::P1213, nowhere(), std::string(text));
  return show(*reference, *value, format);
}

// A forced output stays as it is; a forced input can be set at its terminal, where it waits.
bool Monitor::isForced(const address::Reference& reference) const {
  return reference.operand.area == Area::Output &&
         std::ranges::any_of(forces(),
                             [&](const Forced& one) { return overlap(one.operand, reference); });
}

// A memory reset frees everything; who reset the CPU does not come by here.
const std::vector<Forced>& Monitor::forces() const {
  if (station_.cpu().forces().empty()) forces_.clear();
  return forces_;
}

std::optional<Problem> Monitor::checkWrite(const address::Reference& reference) const {
  if (isForced(reference)) return makeProblem(ProblemCode::P1217, nowhere(), reference.text);
  if (canWrite(station_, reference)) return std::nullopt;
  const bool there = monitor::read(station_, reference).has_value();
  return makeProblem(there ? ProblemCode::P1212 : ProblemCode::P1213, nowhere(), reference.text);
}

std::optional<Problem> Monitor::write(const std::vector<Wish>& wishes) {
  std::vector<std::pair<address::Reference, Value>> good;
  for (const Wish& wish : wishes) {
    auto reference = operand(wish.operand);
    if (!reference) return reference.error();
    auto value = parse(*reference, wish.value, wish.format);
    if (!value) return value.error();
    if (auto problem = checkWrite(*reference)) return problem;
    good.emplace_back(std::move(*reference), std::move(value.value()));
  }
  for (const auto& [reference, value] : good)
    if (!monitor::write(station_, reference, value))
      return makeProblem(ProblemCode::P1212, nowhere(), reference.text);
  return std::nullopt;
}

void Monitor::forceAgain() {
  station_.unforce();
  for (const Forced& one : forces_) station_.force(one.operand, one.value);
}

std::optional<Problem> Monitor::force(const std::vector<Wish>& wishes) {
  std::vector<Forced> good;
  for (const Wish& wish : wishes) {
    auto reference = operand(wish.operand);
    if (!reference) return reference.error();
    const auto value = parse(*reference, wish.value, wish.format);
    if (!canForce(*reference) || !station_.read(*reference))
      return makeProblem(ProblemCode::P1211, nowhere(), std::string(wish.operand));
    if (!value) return value.error();
    if (auto problem = checkForce(forces(), *reference)) return problem;
    if (auto problem = checkForce(good, *reference)) return problem;
    good.push_back({std::move(*reference), value->bits});
  }
  for (Forced& one : good) {
    if (!station_.force(one.operand, one.value))
      return makeProblem(ProblemCode::P1211, nowhere(), one.operand.text);
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
  station_.unforce();
}

VariableTable& Monitor::addTable() { return tables_.emplace_back(station_, resolver_); }

void Monitor::removeTable(const VariableTable& table) {
  tables_.remove_if([&](const VariableTable& one) { return &one == &table; });
}

Stacks Monitor::stacks() const { return monitor::stacks(station_.cpu(), station_.program()); }

std::vector<FrameVariable> Monitor::variables(std::size_t depth) const {
  return frameVariables(station_.cpu(), depth);
}

}  // namespace merker::monitor
