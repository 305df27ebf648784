#include "simulator/device_steps.h"

#include <array>
#include <charconv>

#include "base/text.h"
#include "simulator/line.h"

namespace merker::simulator {
namespace {

using cpu::Light;
using cpu::SwitchPosition;

template <typename Value>
struct Named {
  std::string_view name;
  Value value;
};

constexpr std::array kPositions = {Named<SwitchPosition>{"RUN-P", SwitchPosition::RunP},
                                   Named<SwitchPosition>{"RUN", SwitchPosition::Run},
                                   Named<SwitchPosition>{"STOP", SwitchPosition::Stop},
                                   Named<SwitchPosition>{"MRES", SwitchPosition::Mres}};
constexpr std::array kLights = {Named<Light>{"off", Light::Off}, Named<Light>{"on", Light::On},
                                Named<Light>{"slow", Light::Slow},
                                Named<Light>{"fast", Light::Fast}};
constexpr std::array kLeds = {
    Named<LedMember>{"SF", &cpu::Leds::sf},     Named<LedMember>{"BF", &cpu::Leds::bf},
    Named<LedMember>{"BATF", &cpu::Leds::batf}, Named<LedMember>{"DC5V", &cpu::Leds::dc5v},
    Named<LedMember>{"FRCE", &cpu::Leds::frce}, Named<LedMember>{"RUN", &cpu::Leds::run},
    Named<LedMember>{"STOP", &cpu::Leds::stop}};

template <typename Rows>
auto find(const Rows& rows, std::string_view word) {
  for (const auto& row : rows)
    if (equalsIgnoreCase(row.name, word)) return std::optional(row.value);
  return decltype(std::optional(rows.front().value))();
}

// 40, 16#28, W#16#28, 2#101
std::optional<std::uint32_t> number(std::string_view word) {
  int base = 10;
  const auto last = word.rfind('#');
  if (last != std::string_view::npos) {
    const std::string_view prefix = word.substr(0, last);
    base = prefix.ends_with("16") ? 16 : prefix.ends_with("2") ? 2 : 0;
    word = word.substr(last + 1);
  }
  std::uint32_t value = 0;
  if (base == 0 || word.empty()) return std::nullopt;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

// Takes "coming", "going" or a key and its number off; false if it cannot.
bool takeTerm(std::string_view& words, cpu::Trigger& trigger, std::string_view& wrong,
              std::string& expected) {
  const std::string_view key = takeWord(words);
  wrong = key;
  expected = "coming, going, address N, points N, data N or fault N";
  if (equalsIgnoreCase(key, "coming") || equalsIgnoreCase(key, "going")) {
    trigger.going = equalsIgnoreCase(key, "going");
    return true;
  }
  const bool address = equalsIgnoreCase(key, "address"), fault = equalsIgnoreCase(key, "fault");
  const bool points = equalsIgnoreCase(key, "points"), data = equalsIgnoreCase(key, "data");
  if (!address && !fault && !points && !data) return false;
  const std::string_view text = takeWord(words);
  const auto value = number(text);
  if (!text.empty()) wrong = text;
  expected = address ? "an address from 0 to 65535, as 256 or W#16#100"
             : fault ? "a number of a fault from 1 to 255, as B#16#A1"
                     : "a number, as 5 or DW#16#5";
  if (!value || (address && *value > 0xFFFF) || (fault && (*value == 0 || *value > 0xFF)))
    return false;
  if (address) trigger.address = static_cast<std::uint16_t>(*value);
  if (fault) trigger.fault = static_cast<std::uint8_t>(*value);
  if (points) trigger.points = *value;
  if (data) trigger.data = *value;
  return true;
}

}  // namespace

std::optional<SwitchPosition> parseSwitch(std::string_view word) { return find(kPositions, word); }

ParsedTrigger parseTrigger(std::string_view text) {
  ParsedTrigger result;
  std::string_view words = text;
  const std::string_view kind = takeWord(words), ob = takeWord(words);
  const auto wanted = number(ob);
  if (!equalsIgnoreCase(kind, "OB") || !wanted || !cpu::canTrigger(*wanted)) {
    result.wrong = text;
    result.expected = "OB 40, OB 80 to OB 87, as 'trigger OB 82 coming address 256'";
    return result;
  }
  result.trigger.ob = static_cast<std::uint8_t>(*wanted);
  while (!words.empty())
    if (!takeTerm(words, result.trigger, result.wrong, result.expected)) return result;
  result.expected.clear();
  return result;
}

LedMember parseLed(std::string_view word) { return find(kLeds, word).value_or(nullptr); }

std::optional<Light> parseLight(std::string_view word) { return find(kLights, word); }

std::string_view name(Light light) { return kLights[static_cast<std::size_t>(light)].name; }

}  // namespace merker::simulator
