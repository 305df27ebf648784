#include "monitor/forced.h"

#include "scenario/term.h"

namespace merker::monitor {
namespace {

std::uint32_t bitsOf(const address::Reference& reference) {
  return reference.bytes > 0 ? 8 * reference.bytes : simulator::bitWidth(reference);
}

}  // namespace

bool samePlace(const address::Reference& a, const address::Reference& b) {
  return a.operand == b.operand && a.db == b.db && a.nc == b.nc && a.partner == b.partner;
}

bool overlap(const address::Reference& a, const address::Reference& b) {
  return a.partner == b.partner && a.nc == b.nc && a.operand.kind == b.operand.kind &&
         a.operand.area == b.operand.area && a.db == b.db &&
         a.operand.value < b.operand.value + bitsOf(b) &&
         b.operand.value < a.operand.value + bitsOf(a);
}

std::optional<Problem> checkForce(const std::vector<Forced>& list,
                                  const address::Reference& operand) {
  for (const Forced& one : list)
    if (overlap(one.operand, operand) && !samePlace(one.operand, operand))
      return makeProblem(ProblemCode::P1219, Position{"", 0, 0, 0}, operand.text, one.operand.text);
  return std::nullopt;
}

}  // namespace merker::monitor
