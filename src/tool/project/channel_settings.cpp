// [[module.channel]] of merker.toml: analog channels (S7-HWCFG-09).
#include <fmt/format.h>

#include <array>

#include "base/text.h"
#include "io/amount.h"
#include "project/readers.h"

namespace merker::project {
namespace {

// A channel that its table names, with what can be set on it.
struct Channel {
  const Table& table;
  const io::Module& module;
  unsigned number;
  void hasNo(std::string_view key, std::string_view what) const {
    table.problems().add(ProblemCode::P0735, table.placeOf(key),
                         fmt::format("channel {} of {}", number, module.title()), what);
  }
};

// "off" deactivates the channel. False if the range is wrong.
bool readRange(const Channel& c, std::uint16_t possible, const MeasuringRange*& range) {
  const auto text = c.table.text("range", "a range: \"4..20mA\", or \"off\"");
  if (!text) return true;
  if (equalsIgnoreCase(*text, "off")) {
    range = nullptr;
    return true;
  }
  const MeasuringRange* found = findMeasuringRange(*text);
  if (found == nullptr || (found->sets & possible) == 0) {
    c.table.problems().add(ProblemCode::P0737, c.table.at("range"),
                           fmt::format("range \"{}\"", *text),
                           fmt::format("channel {} of {}", c.number, c.module.title()),
                           rangeNames(possible) + ", off");
    return false;
  }
  range = found;
  return true;
}

std::string within(const MeasuringRange& range) {
  return fmt::format("from {} to {}", io::formatAmount(range.low, range.quantity),
                     io::formatAmount(range.high, range.quantity));
}

std::optional<double> readAmount(const Channel& c, std::string_view key,
                                 const MeasuringRange* range) {
  const auto text = c.table.text(key, "an amount with its unit: \"5V\"");
  if (!text) return std::nullopt;
  if (range == nullptr) {
    c.table.problems().add(ProblemCode::P0744, c.table.placeOf(key), key, "a range other than off");
    return std::nullopt;
  }
  const auto amount = io::parseAmount(*text, range->quantity);
  if (!amount)
    c.table.problems().add(ProblemCode::P0740, c.table.at(key), *text,
                           fmt::format("an amount in {}", unitOf(range->quantity)),
                           io::formatAmount((range->low + range->high) / 2, range->quantity));
  else if (*amount < range->low || *amount > range->high)
    c.table.problems().add(ProblemCode::P0741, c.table.at(key), key, c.number, within(*range));
  else
    return amount;
  return std::nullopt;
}

void readLimits(const Channel& c, io::AnalogInput& input) {
  const bool possible = (c.module.type->interruptChannels >> c.number & 1) != 0;
  for (const std::string_view key : {"upper_limit", "lower_limit"})
    if (c.table.has(key) && !possible) return c.hasNo(key, "limits with a hardware interrupt");
  input.upperLimit = readAmount(c, "upper_limit", input.range);
  input.lowerLimit = readAmount(c, "lower_limit", input.range);
  if (input.upperLimit && input.lowerLimit && *input.lowerLimit >= *input.upperLimit)
    c.table.problems().add(ProblemCode::P0741, c.table.at("lower_limit"), "lower_limit", c.number,
                           "below its upper_limit");
}

void readWireBreak(const Channel& c, io::AnalogInput& input) {
  const auto wanted = c.table.flag("wire_break");
  if (!wanted) return;
  input.wireBreakCheck = *wanted;
  if (*wanted && !c.module.type->wireBreakCheck) return c.hasNo("wire_break", "wire break check");
  if (*wanted && (input.range == nullptr || input.range->wireBreak == 0))
    c.table.problems().add(ProblemCode::P0744, c.table.placeOf("wire_break"), "wire_break",
                           "range = \"4..20mA\"");
}

void readInput(const Table& table, io::Module& module, unsigned number) {
  const Channel c{table, module, number};
  table.allow({"input", "range", "wire_break", "upper_limit", "lower_limit"});
  io::AnalogInput& input = module.parameters.analogInputs[number];
  if (!readRange(c, module.type->rangesOfInput(number), input.range)) return;
  readWireBreak(c, input);
  readLimits(c, input);
}

void readOutput(const Table& table, io::Module& module, unsigned number) {
  const Channel c{table, module, number};
  table.allow({"output", "range", "substitute"});
  io::AnalogOutput& output = module.parameters.analogOutputs[number];
  if (!readRange(c, module.type->outputRanges, output.range)) return;
  if (!table.has("substitute")) return;
  if (module.parameters.onStop != io::OnStop::Substitute)
    table.problems().add(ProblemCode::P0744, table.placeOf("substitute"), "substitute",
                         "on_stop = \"substitute\" of its module");
  else
    output.substitute = readAmount(c, "substitute", output.range).value_or(0);
}

// The channel, if it exists and was not set before.
std::optional<unsigned> readNumber(const Table& table, std::string_view key,
                                   const io::Module& module, unsigned count, std::uint32_t& seen) {
  const auto number = table.number(key, 0, 255);
  if (!number) return std::nullopt;
  if (*number >= count) {
    table.problems().add(ProblemCode::P0738, table.at(key), *number, module.title(),
                         count == 0 ? fmt::format("no analog {}s", key)
                                    : fmt::format("analog {}s 0 to {}", key, count - 1));
    return std::nullopt;
  }
  if ((seen >> *number & 1) != 0) table.problems().add(ProblemCode::P0745, table.at(key), *number);
  seen |= 1u << *number;
  return *number;
}

}  // namespace

namespace {

// Where channels were given a range, by input.
using RangePositions = std::array<Position, 8>;

// S7-HWCFG-09: parameter data record of the module: one byte a group (manual "S7-300 Module data").
void checkRangeGroups(const io::Module& module, const RangePositions& set, Problems& problems) {
  const unsigned step = module.type->rangeGroup;
  if (step != 2) return;
  const auto& inputs = module.parameters.analogInputs;
  for (unsigned c = 0; c + 1 < module.type->analogInputs; c += step) {
    const MeasuringRange *one = inputs[c].range, *other = inputs[c + 1].range;
    if (one == nullptr || other == nullptr || one == other) continue;
    const Position& later = set[c + 1].line > set[c].line ? set[c + 1] : set[c];
    problems.add(ProblemCode::P0751, later, c, c + 1, module.title());
  }
}

}  // namespace

void readChannels(const Table& table, io::Module& module) {
  std::uint32_t inputs = 0, outputs = 0;
  RangePositions ranges;
  for (const Table& channel : table.tables("channel")) {
    const bool output = channel.has("output");
    if (output == channel.has("input")) {
      channel.problems().add(ProblemCode::P0744, channel.place(), channel.title(),
                             channel.has("number") ? "slot = \"2.4\": counters have a 'number'; "
                                                     "analog channels an 'input' or 'output'"
                                                   : "either input = NUMBER or output = NUMBER");
    } else if (output) {
      if (const auto number =
              readNumber(channel, "output", module, module.type->analogOutputs, outputs))
        readOutput(channel, module, *number);
    } else if (const auto number =
                   readNumber(channel, "input", module, module.type->analogInputs, inputs)) {
      readInput(channel, module, *number);
      if (channel.has("range")) ranges[*number] = channel.at("range");
    }
  }
  checkRangeGroups(module, ranges, table.problems());
}

}  // namespace merker::project
