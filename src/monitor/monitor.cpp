#include "monitor/monitor.h"

#include "cpu/cpu.h"

namespace merker::monitor {
namespace {

Position nowhere() { return Position{"", 0, 0, 0}; }

bool samePlace(const mc7::Reference& a, const mc7::Reference& b) {
  return a.operand == b.operand && a.db == b.db;
}

}  // namespace

Monitor::Monitor(station::Station& station, const source::SymbolTable& symbols,
                 simulator::Resolver resolver)
    : station_(station), symbols_(symbols), resolver_(std::move(resolver)), debugger_(station) {
  station_.cpu().onCyclePoint([this](cpu::CyclePoint point) {
    for (VariableTable& table : tables_) table.reached(point);
  });
}

Monitor::~Monitor() { station_.cpu().onCyclePoint({}); }

LocationContext Monitor::locations(std::string currentFile) const {
  return {station_.program(), symbols_, std::move(currentFile)};
}

Result<mc7::Reference> Monitor::operand(std::string_view text) const {
  auto reference = resolver_(text, nowhere());
  if (reference && reference->operand.kind != mc7::OperandKind::Memory)
    reference->operand.width = Width::Word;  // T, Z: what LC loads
  return reference;
}

Result<std::string> Monitor::read(std::string_view text, DisplayFormat format) const {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  const unsigned bits = simulator::bitWidth(*reference);
  if (!fits(format, bits))
    return makeProblem(ProblemCode::P1209, nowhere(), std::string(text), name(format),
                       bitsText(format));
  const auto value = station_.read(*reference);
  if (!value) return makeProblem(ProblemCode::P1213, nowhere(), std::string(text));
  return show(*reference, *value, format);
}

std::optional<Problem> Monitor::write(std::string_view text, std::string_view value,
                                      DisplayFormat format) {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  const auto bits = parseValue(*reference, value, format);
  if (!bits) return bits.error();
  if (station_.write(*reference, *bits)) return std::nullopt;
  return makeProblem(ProblemCode::P1212, nowhere(), std::string(text));
}

std::optional<Problem> Monitor::force(std::string_view text, std::string_view value) {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  const auto bits = parseValue(*reference, value, DisplayFormat::Automatic);
  if (!bits) return bits.error();
  if (!station_.force(*reference, *bits))
    return makeProblem(ProblemCode::P1211, nowhere(), std::string(text));
  std::erase_if(forces_, [&](const Forced& one) { return samePlace(one.operand, *reference); });
  forces_.push_back({*reference, *bits});
  return std::nullopt;
}

std::optional<Problem> Monitor::unforce(std::string_view text) {
  const auto reference = operand(text);
  if (!reference) return reference.error();
  const auto removed =
      std::erase_if(forces_, [&](const Forced& one) { return samePlace(one.operand, *reference); });
  if (removed == 0) return makeProblem(ProblemCode::P1214, nowhere(), std::string(text));
  station_.unforce();  // what overlaps it stays
  for (const Forced& one : forces_) station_.force(one.operand, one.value);
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
