#include "scenario/steps/trigger.h"

#include <charconv>
#include <optional>
#include <string>

#include "base/text.h"

namespace merker::simulator::steps {
namespace {

// 40, 16#28, W#16#28, 2#101
std::optional<std::uint32_t> eventNumber(std::string_view word) {
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
bool takeTerm(std::string_view& words, cpu::Trigger& event, std::string_view& wrong,
              std::string& expected) {
  const std::string_view key = takeWord(words);
  wrong = key;
  expected = "coming, going, address N, points N, data N or fault N";
  if (equalsIgnoreCase(key, "coming") || equalsIgnoreCase(key, "going")) {
    event.going = equalsIgnoreCase(key, "going");
    return true;
  }
  const bool address = equalsIgnoreCase(key, "address"), fault = equalsIgnoreCase(key, "fault");
  const bool points = equalsIgnoreCase(key, "points"), data = equalsIgnoreCase(key, "data");
  if (!address && !fault && !points && !data) return false;
  const std::string_view text = takeWord(words);
  const auto value = eventNumber(text);
  if (!text.empty()) wrong = text;
  expected = address ? "an address from 0 to 65535: 256 or W#16#100"
             : fault ? "a fault number from 1 to 255: B#16#A1"
                     : "a number: 5 or DW#16#5";
  if (!value || (address && *value > 0xFFFF) || (fault && (*value == 0 || *value > 0xFF)))
    return false;
  if (address) event.address = static_cast<std::uint16_t>(*value);
  if (fault) event.fault = static_cast<std::uint8_t>(*value);
  if (points) event.points = *value;
  if (data) event.data = *value;
  return true;
}

}  // namespace

bool Trigger::parse(const StepLine& line) {
  std::string_view words = line.rest();
  const std::string_view kind = takeWord(words), ob = takeWord(words);
  const auto wanted = eventNumber(ob);
  if (!equalsIgnoreCase(kind, "OB") || !wanted || !cpu::canTrigger(*wanted))
    return line.fail(ProblemCode::P0952, line.rest(),
                     "OB 40, OB 80 to OB 87: 'trigger OB 82 coming address 256'");
  event.ob = static_cast<std::uint8_t>(*wanted);
  std::string_view wrong;
  std::string expected;
  while (!words.empty())
    if (!takeTerm(words, event, wrong, expected))
      return line.fail(ProblemCode::P0952, wrong, expected);
  return true;
}

bool Trigger::perform(StepRun& run) const {
  auto* const plc = run.need<cpu::EventsByHand>();
  if (plc == nullptr || !run.powered()) return false;
  plc->trigger(event);
  return true;
}

}  // namespace merker::simulator::steps
