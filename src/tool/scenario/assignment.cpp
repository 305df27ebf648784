#include "scenario/assignment.h"

#include <fmt/format.h>

#include "base/bcd.h"
#include "base/text.h"
#include "scenario/comparison.h"
#include "scenario/display.h"
#include "scenario/line.h"
#include "scenario/long_value.h"

namespace merker::simulator {
namespace {

bool parseAssignment(const StepLine& line, std::string_view text, Assignment& assignment) {
  const auto sign = findOutside(text, [](std::string_view rest) { return rest[0] == '='; });
  if (sign == std::string_view::npos) return line.fail(ProblemCode::P0952, text, "OPERAND = VALUE");
  return line.term(assignment.operand, trim(text.substr(0, sign)), text, "an operand") &&
         line.term(assignment.value, trim(text.substr(sign + 1)), text, "a value");
}

// Whether the set bits of a constant have a place in the operand.
bool fits(const Constant& constant, const address::Reference& reference) {
  const unsigned width = bitWidth(reference);
  return width >= 32 || adapt(constant, reference.type).bits >> width == 0;
}

// Characters of a STRING; eight bytes of a DATE_AND_TIME always fit.
std::size_t longest(const address::Reference& reference) {
  if (reference.nc != 0) return SIZE_MAX;
  return reference.type == TypeCode::String ? reference.bytes - 2 : reference.bytes;
}

// A counter takes its count in BCD (C#, KZ); all else means the count. Nothing if there is no such
// count.
std::optional<std::uint32_t> coded(const Assignment& assignment, std::uint32_t bits) {
  const auto& constant = assignment.value.constant;
  const bool word = constant && constant->format == ConstantFormat::Counter;
  if (!address::isCounter(assignment.operand.reference.operand) || word) return bits;
  return bits <= 999 ? std::optional(toBcd(bits, 3)) : std::nullopt;
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

std::vector<Assignment> parseAssignments(const StepLine& line) {
  std::vector<Assignment> list;
  for (const std::string_view part : splitList(line.rest()))
    if (Assignment one; parseAssignment(line, part, one)) list.push_back(std::move(one));
  return list;
}

std::vector<Assignment> parseAssignments(const source::SourceFile& file, std::string_view text,
                                         Problems& problems) {
  return parseAssignments(StepLine(file, text, text, problems));
}

void resolve(Assignment& assignment, const Resolver& resolver, Problems& problems) {
  auto& [operand, value] = assignment;
  const std::size_t before = problems.size();
  resolvePair(operand, value, resolver, problems);
  if (problems.size() > before) return;
  if (operand.constant)
    problems.add(ProblemCode::P0904, operand.position, operand.text);
  else if (value.content && value.content->size() > longest(operand.reference))
    problems.add(ProblemCode::P0961, value.position, value.text, value.content->size(),
                 operand.text, longest(operand.reference));
  else if (value.constant && !fits(*value.constant, operand.reference))
    problems.add(ProblemCode::P0955, value.position, value.text, operand.text,
                 bitWidth(operand.reference));
}

std::string apply(const Assignment& assignment, bool force, controller::Controller& plc) {
  const auto& [operand, term] = assignment;
  if (isLong(operand.reference)) return applyLong(assignment, force, plc);
  const Reader read = [&](const address::Reference& reference) { return plc.read(reference); };
  const auto bits = value(term, operand, read);
  if (!bits) return fmt::format("{} does not exist", term.text);
  if (lacksBase(assignment))
    return fmt::format("{} needs value and base, for example KT 500.1 (50 s), not {}", operand.text,
                       term.text);
  const auto value = coded(assignment, *bits);
  if (value &&
      (force ? plc.force(operand.reference, *value) : plc.write(operand.reference, *value)))
    return {};
  return refused(operand, force, plc);
}

}  // namespace merker::simulator
