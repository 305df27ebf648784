#include "scenario/forced.h"

#include <algorithm>

#include "scenario/term.h"

namespace merker::simulator {
namespace {

std::uint32_t bitsOf(const address::Reference& reference) {
  return reference.bytes > 0 ? 8 * reference.bytes : bitWidth(reference);
}

}  // namespace

bool samePlace(const address::Reference& a, const address::Reference& b) {
  return a.operand == b.operand && a.db == b.db && a.nc == b.nc && a.partner == b.partner &&
         a.station == b.station;
}

bool overlap(const address::Reference& a, const address::Reference& b) {
  return a.partner == b.partner && a.station == b.station && a.nc == b.nc &&
         a.operand.kind == b.operand.kind && a.operand.area == b.operand.area && a.db == b.db &&
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

std::optional<Problem> checkOnce(const std::vector<Forced>& list,
                                 const address::Reference& operand) {
  for (const Forced& one : list)
    if (samePlace(one.operand, operand))
      return makeProblem(ProblemCode::P0988, Position{"", 0, 0, 0}, operand.text,
                         "the list names it twice");
  return checkForce(list, operand);
}

namespace {

std::string messageOf(const std::optional<Problem>& problem) {
  return problem ? problem->message : std::string();
}

}  // namespace

std::string ForceList::whyNotForced(const address::Reference& operand) const {
  return messageOf(checkForce(list_, operand));
}

std::string ForceList::whyNotTwice(const address::Reference& operand) const {
  return messageOf(checkOnce(list_, operand));
}

std::string ForceList::whyNotSet(const address::Reference& operand) const {
  const bool held =
      operand.operand.area != Area::Input &&
      std::ranges::any_of(list_, [&](const Forced& one) { return overlap(one.operand, operand); });
  if (!held) return {};
  return makeProblem(ProblemCode::P1217, Position{"", 0, 0, 0}, operand.text).message;
}

void ForceList::add(const address::Reference& operand) {
  const auto same = [&](const Forced& one) { return samePlace(one.operand, operand); };
  if (std::ranges::none_of(list_, same)) list_.push_back({operand, 0});
}

void ForceList::clear(std::size_t station) {
  std::erase_if(list_, [&](const Forced& one) {
    return one.operand.station == 0 || one.operand.station == station + 1;
  });
}

void ForceList::clearPartner() {
  std::erase_if(list_, [](const Forced& one) { return one.operand.partner; });
}

}  // namespace merker::simulator
