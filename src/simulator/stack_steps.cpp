#include "simulator/stack_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "controller/stop_screens.h"
#include "simulator/line.h"
#include "simulator/relation.h"

namespace merker::simulator {
namespace {

using controller::Controller;
using controller::Mode;
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

const StopScreens* screensOf(const Controller& plc) {
  return dynamic_cast<const StopScreens*>(&plc);
}

bool shown(const Controller& plc) { return plc.mode() == Mode::Stop && plc.powered(); }

}  // namespace

bool takeStack(std::string_view& left, StackField& field) {
  std::string_view rest = left;
  const std::string_view word = takeWord(rest);
  if (!equalsIgnoreCase(word, "ustack") && !equalsIgnoreCase(word, "bstack")) return false;
  field.stack = upper(word);
  field.name = rest;
  left = rest;
  return true;
}

bool holds(const StackField& field, block::Relation relation, const Controller& plc) {
  const StopScreens* const screens = screensOf(plc);
  if (screens == nullptr || !shown(plc)) return false;
  const auto text = screens->stackField(field.stack, field.name);
  if (!text) return false;
  const auto actual = hexadecimal(*text), wanted = hexadecimal(field.value);
  if (actual && wanted) return relates(*actual, relation, *wanted);
  const bool equal = withoutBlanks(*text) == withoutBlanks(field.value);
  return relation == block::Relation::Equal      ? equal
         : relation == block::Relation::NotEqual ? !equal
                                                 : false;
}

std::string actualValue(const StackField& field, const Controller& plc) {
  const StopScreens* const screens = screensOf(plc);
  if (screens == nullptr) return fmt::format("{} has no {}", plc.modelName(), field.stack);
  const auto text = screens->stackField(field.stack, field.name);
  if (!text)
    return fmt::format("the {} has no field '{}'; there are: {}", field.stack, field.name,
                       screens->stackFields(field.stack));
  if (!shown(plc)) return fmt::format("the PLC is not in STOP, which the {} needs", field.stack);
  return fmt::format("{} is {}", field.name, *text);
}

}  // namespace merker::simulator
