// Sets operands from outside the program.
#include <fmt/format.h>

#include "base/bcd.h"
#include "simulator/comparison.h"
#include "simulator/display.h"
#include "simulator/long_value.h"
#include "simulator/scenario.h"

namespace merker::simulator {
namespace {

// A counter takes its count in BCD (C#); a plain number means the count.
std::uint32_t coded(const Assignment& assignment, std::uint32_t bits) {
  const bool counter = assignment.operand.reference.operand.kind == address::OperandKind::Counter;
  const auto& constant = assignment.value.constant;
  const bool number = !constant || constant->format != ConstantFormat::Counter;
  return counter && number && bits <= 999 ? toBcd(bits, 3) : bits;
}

std::string refused(const Term& operand, bool force, const controller::Controller& plc) {
  const std::string reason = force ? std::string() : plc.whyRefused(operand.reference);
  return fmt::format("{} cannot be {}{}{}", operand.text, force ? "forced" : "set",
                     reason.empty() ? "" : ": ", reason);
}

// A number alone says nothing of the base that a timer counts with.
bool lacksBase(const Assignment& assignment) {
  const auto& [operand, value] = assignment;
  if (operand.reference.operand.kind != address::OperandKind::Timer) return false;
  const bool number = value.constant && (value.constant->format == ConstantFormat::Integer ||
                                         value.constant->format == ConstantFormat::LongInteger ||
                                         value.constant->format == ConstantFormat::Counter);
  return number && isStep5Cell(operand.reference);
}

std::string applyLong(const Assignment& assignment, bool force, controller::Controller& plc) {
  const auto content = longValue(assignment.value, plc);
  if (!content) return fmt::format("{} does not exist", assignment.value.text);
  const bool done = !force && writeLong(assignment.operand.reference, *content, plc);
  return done ? std::string() : refused(assignment.operand, force, plc);
}

}  // namespace

std::string apply(const Assignment& assignment, bool force, controller::Controller& plc) {
  const auto& [operand, term] = assignment;
  if (isLong(operand.reference)) return applyLong(assignment, force, plc);
  const Reader read = [&](const address::Reference& reference) { return plc.read(reference); };
  const auto bits = value(term, operand, read);
  if (!bits) return fmt::format("{} does not exist", term.text);
  if (lacksBase(assignment))
    return fmt::format("{} takes value and base, as KT 500.1 (50 s), not {}", operand.text,
                       term.text);
  const std::uint32_t value = coded(assignment, *bits);
  if (force ? plc.force(operand.reference, value) : plc.write(operand.reference, value)) return {};
  return refused(operand, force, plc);
}

}  // namespace merker::simulator
