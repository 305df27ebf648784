// [nc] of merker.toml: what the NC side holds at the start (S5-FM: FB 56 to 58, FB 61, FB 62).
#include <charconv>

#include "project/numbered_keys.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using nc::Control;

constexpr std::string_view kDecimal = "a text of at most eight digits with a point: \"1425.67\"";

constexpr KeyRange kWords[] = {{0, nc::kDataWords - 1, INT32_MIN, INT32_MAX}};
constexpr KeyRange kAxes[] = {{1, nc::kAxes, INT32_MIN, INT32_MAX}};
constexpr KeyRange kSpindles[] = {{1, nc::kSpindles, INT32_MIN, INT32_MAX}};
constexpr KeyRange kTools[] = {{1, nc::kTools, 0, 0}};
constexpr KeyRange kToolValues[] = {{0, nc::kToolValues - 1, 0, 0}};
constexpr KeyRange kChannels[] = {{0, nc::kChannels, 0, 0}};
constexpr KeyRange kParameters[] = {{0, nc::kChannelParameters - 1, 0, 0}};
constexpr KeyRange kCentral[] = {{900, 999, 0, 0}};

std::optional<nc::Number> number(std::string_view text) {
  std::string digits(text);
  const std::size_t point = digits.find('.');
  const std::size_t places = point == std::string::npos ? 0 : digits.size() - point - 1;
  if (point != std::string::npos) digits.erase(point, 1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return nc::makeNumber(value, static_cast<unsigned>(std::min<std::size_t>(places, 9)));
}

// Keys with decimal numbers: `take(number of the key, value)`.
template <typename Take>
void eachDecimal(const Table& table, std::span<const KeyRange> ranges, std::string_view possible,
                 Take take) {
  eachKey(table, ranges, possible, [&](unsigned key, const std::string& name, const KeyRange&) {
    const auto text = table.text(name, kDecimal);
    if (!text) return;
    if (const auto value = number(*text))
      take(key, *value);
    else
      table.mustBe(name, kDecimal);
  });
}

void readAxes(const Table& nc, Control& control) {
  if (const auto table = nc.table("position"))
    eachNumber(*table, kAxes, "1 to 5", [&](unsigned axis, std::int64_t value) {
      control.axes.at(axis - 1).position = static_cast<nc::Count>(value);
    });
  if (const auto table = nc.table("following_error"))
    eachNumber(*table, kAxes, "1 to 5", [&](unsigned axis, std::int64_t value) {
      control.axes.at(axis - 1).followingError = static_cast<std::int32_t>(value);
    });
  if (const auto table = nc.table("feed"))  // G94
    eachDecimal(*table, kAxes, "1 to 5", [&](unsigned axis, nc::Number value) {
      control.axes.at(axis - 1).feed.at(0) = value;
    });
  if (const auto table = nc.table("spindle_speed"))
    eachNumber(*table, kSpindles, "1, 2", [&](unsigned spindle, std::int64_t value) {
      control.spindleSpeed.at(spindle - 1) = static_cast<std::int32_t>(value);
    });
}

// [nc.tool.7]: P numbers of tool offset D 7.
void readTools(const Table& tools, Control& control) {
  eachKey(tools, kTools, "D numbers 1 to 99", [&](unsigned d, const std::string& key, const auto&) {
    if (const auto table = tools.table(key))
      eachDecimal(*table, kToolValues, "P numbers 0 to 15",
                  [&](unsigned p, nc::Number value) { control.tools.at(d - 1).at(p) = value; });
  });
}

// [nc.parameters.1]: R 0 to R 499 of channel 1; [nc.parameters.0]: the central ones, R 900 to R
// 999.
void readParameters(const Table& channels, Control& control) {
  eachKey(channels, kChannels, "channels 1 and 2, 0 for the central ones",
          [&](unsigned channel, const std::string& key, const auto&) {
            const auto table = channels.table(key);
            if (!table) return;
            const bool central = channel == 0;
            eachDecimal(*table, central ? kCentral : kParameters,
                        central ? "R 900 to 999" : "R 0 to 499", [&](unsigned r, nc::Number value) {
                          if (central)
                            control.centralParameters.at(r - 900) = value;
                          else
                            control.parameters.at(channel - 1).at(r) = value;
                        });
          });
}

void readWords(const Table& nc, std::string_view key, std::vector<std::int32_t>& words) {
  if (const auto table = nc.table(key))
    eachNumber(*table, kWords, "0 to 4999", [&](unsigned word, std::int64_t value) {
      words.at(word) = static_cast<std::int32_t>(value);
    });
}

}  // namespace

void readNc(const Table& table, Control& control) {
  table.allow({"input_system", "machine_data", "setting_data", "position", "following_error",
               "feed", "spindle_speed", "tool", "parameters", "alarms", "machining_stop"});
  if (const auto system = table.choice("input_system", {"metric", "inch"}))
    control.inputSystem = *system == 0 ? nc::InputSystem::Metric : nc::InputSystem::Inch;
  for (const Table::Number& alarm : table.numbers("alarms", "numbers of NC alarms"))
    control.raise(static_cast<std::uint16_t>(std::min<std::uint32_t>(alarm.value, 0xFFFF)));
  if (const auto stop = table.flag("machining_stop")) control.machiningStop = *stop;
  readWords(table, "machine_data", control.machineData);
  readWords(table, "setting_data", control.settingData);
  readAxes(table, control);
  if (const auto tools = table.table("tool")) readTools(*tools, control);
  if (const auto channels = table.table("parameters")) readParameters(*channels, control);
}

}  // namespace merker::project
