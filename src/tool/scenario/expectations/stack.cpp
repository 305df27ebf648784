#include "scenario/expectations/stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "check/relation.h"
#include "plc/stop_screens.h"

namespace merker::simulator::expectations {
namespace {

using controller::Controller;
using controller::StopScreens;

// "0000 0007" is one number, "PB 5" and "PB5" are one block.
std::string withoutBlanks(std::string_view text) {
  std::string result = upper(text);
  std::erase(result, ' ');
  return result;
}

std::optional<std::uint64_t> hexadecimal(std::string_view text) {
  std::string digits = withoutBlanks(text);
  for (const std::string_view prefix : {"KH", "DW#16#", "W#16#", "B#16#", "16#"})
    if (digits.starts_with(prefix)) digits.erase(0, prefix.size());
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole && !digits.empty() ? std::optional(value) : std::nullopt;
}

bool shown(const Controller& plc) { return plc.mode() == controller::Mode::Stop && plc.powered(); }

}  // namespace

bool Stack::parse(const StepLine& line, const Claim& claim) {
  const auto fail = [&](std::string_view expected) {
    return line.fail(ProblemCode::P0952, claim.whole, expected);
  };
  stack = upper(claim.word);
  name = claim.subject;
  value = claim.value;
  relation = claim.relation;
  if (relation == block::Relation::About) return fail("a comparison (= <> < <= > >=)");
  if (name.empty()) return fail("a field: ustack SAZ = 002A");
  return !value.empty() || fail("a value: 002A or PB 5");
}

bool Stack::holds(Controller& plc) const {
  const StopScreens* const screens = controller::capability<StopScreens>(plc);
  if (screens == nullptr || !shown(plc)) return false;
  const auto text = screens->stackField(stack, name);
  if (!text) return false;
  const auto actual = hexadecimal(*text), wanted = hexadecimal(value);
  if (actual && wanted) return block::relates(*actual, relation, *wanted);
  const bool equal = withoutBlanks(*text) == withoutBlanks(value);
  return relation == block::Relation::Equal      ? equal
         : relation == block::Relation::NotEqual ? !equal
                                                 : false;
}

std::string Stack::actual(Controller& plc) const {
  const StopScreens* const screens = controller::capability<StopScreens>(plc);
  if (screens == nullptr) return fmt::format("{} has no {}", plc.modelName(), stack);
  const auto text = screens->stackField(stack, name);
  if (!text)
    return fmt::format("the {} has no field '{}'; valid: {}", stack, name,
                       screens->stackFields(stack));
  if (!shown(plc)) return fmt::format("the PLC is not in STOP, which the {} needs", stack);
  return fmt::format("{} is {}", name, *text);
}

}  // namespace merker::simulator::expectations
