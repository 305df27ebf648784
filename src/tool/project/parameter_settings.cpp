// Parameters of a module in merker.toml (S7-HWCFG-09): input delay, edges, diagnosis, behaviour in
// STOP.
#include <fmt/format.h>

#include <algorithm>

#include "io/amount.h"
#include "project/readers.h"

namespace merker::project {
namespace {

void hasNo(const Table& table, std::string_view key, const io::Module& module,
           std::string_view what) {
  table.problems().add(ProblemCode::P0735, table.placeOf(key), module.title(), what);
}

void readDelay(const Table& table, io::Module& module) {
  if (!table.has("input_delay")) return;
  if (module.type->inputDelays.empty())
    return hasNo(table, "input_delay", module, "adjustable input delay");
  const auto text = table.text("input_delay", "a duration: \"3ms\"");
  if (!text) return;
  const auto length = io::parseLength(*text);
  std::string possible;
  for (const std::uint32_t delay : module.type->inputDelays) {
    const Duration known = Duration::microseconds(delay);
    if (length && *length == known) {
      module.parameters.inputDelay = known;
      return;
    }
    possible += (possible.empty() ? "" : ", ") + io::formatLength(known);
  }
  table.problems().add(ProblemCode::P0737, table.at("input_delay"),
                       fmt::format("input delay \"{}\"", *text), module.title(), possible);
}

// A bit for each channel that the list names; `count` channels exist.
std::uint32_t readBits(const Table& table, std::string_view key, const io::Module& module,
                       unsigned count) {
  std::uint32_t bits = 0;
  for (const Table::Number& number : table.numbers(key, "a list of channels: [0, 1]")) {
    if (number.value < count)
      bits |= 1u << number.value;
    else
      table.problems().add(ProblemCode::P0738, number.position, number.value, module.title(),
                           fmt::format("channels 0 to {}", count - 1));
  }
  return bits;
}

// Channels whose interrupts share a setting are named together (module data manual, SM 321 7BH).
void checkGroups(const Table& table, std::string_view key, const io::Module& module,
                 std::uint32_t bits) {
  for (unsigned c = 0; c < module.type->digitalInputs; c += 2)
    if ((bits >> c & 1) != (bits >> (c + 1) & 1))
      table.problems().add(ProblemCode::P0739, table.at(key), c, c + 1, module.title());
}

void readEdges(const Table& table, std::string_view key, io::Module& module, std::uint32_t& edges) {
  if (!table.has(key)) return;
  if (module.type->digitalInputs == 0 || module.type->interruptChannels == 0)
    return hasNo(table, key, module, "hardware interrupts of digital inputs");
  edges = readBits(table, key, module, module.type->digitalInputs);
  if (module.type->interruptGroup == 2) checkGroups(table, key, module, edges);
}

void readDiagnostics(const Table& table, io::Module& module) {
  const auto wanted = table.flag("diagnostics");
  if (!wanted) return;
  const ModuleKind kind = module.type->kind;
  if (kind == ModuleKind::Counting || kind == ModuleKind::Positioning)  // CNT-PARAM-02
    return hasNo(table, "diagnostics", module,
                 "'diagnostics'; its interrupts are selected by interrupts = \"diagnostics\"");
  if (*wanted && !module.type->diagnosticInterrupt)
    return hasNo(table, "diagnostics", module, "diagnostic interrupt");
  module.parameters.diagnosticInterrupt = *wanted;
}

// Sets the range of all channels that can have it.
void readRange(const Table& table, io::Module& module) {
  const auto text = table.text("range", "a range: \"±10V\"");
  if (!text) return;
  const ModuleType& type = *module.type;
  if (type.kind != ModuleKind::Analog) return hasNo(table, "range", module, "analog channels");
  const MeasuringRange* range = findMeasuringRange(*text);
  bool any = false;
  for (unsigned c = 0; range != nullptr && c < type.analogInputs; ++c) {
    if ((range->sets & type.rangesOfInput(c)) == 0) continue;
    module.parameters.analogInputs[c].range = range;
    any = true;
  }
  for (unsigned c = 0; range != nullptr && c < type.analogOutputs; ++c) {
    if ((range->sets & type.outputRanges) == 0) continue;
    module.parameters.analogOutputs[c].range = range;
    any = true;
  }
  if (!any)
    table.problems().add(ProblemCode::P0737, table.at("range"), fmt::format("range \"{}\"", *text),
                         module.title(),
                         rangeNames(type.analogInputs > 0 ? type.inputRanges : type.outputRanges));
}

void readOnStop(const Table& table, io::Module& module) {
  const auto onStop = table.choice("on_stop", {"zero", "keep", "substitute"});
  if (onStop) {
    if (*onStop != 0 && !module.type->substituteValues)
      return hasNo(table, "on_stop", module, "choice: its outputs are 0 in STOP");
    module.parameters.onStop = static_cast<io::OnStop>(*onStop);
  }
  if (!table.has("substitute")) return;
  if (module.type->digitalOutputs == 0)
    return hasNo(table, "substitute", module,
                 "digital outputs; analog ones have their value in [[module.channel]]");
  if (module.parameters.onStop != io::OnStop::Substitute) {
    table.problems().add(ProblemCode::P0744, table.placeOf("substitute"), "substitute",
                         "on_stop = \"substitute\"");
    return;
  }
  module.parameters.substituteBits =
      readBits(table, "substitute", module, module.type->digitalOutputs);
}

}  // namespace

std::string rangeNames(std::uint16_t sets) {
  std::string list;
  for (const MeasuringRange& range : measuringRanges())
    if ((range.sets & sets) != 0) list += fmt::format("{}{}", list.empty() ? "" : ", ", range.name);
  return list.empty() ? "none" : list;
}

void readParameters(const Table& table, io::Module& module) {
  readDelay(table, module);
  readEdges(table, "rising_edge", module, module.parameters.risingEdges);
  readEdges(table, "falling_edge", module, module.parameters.fallingEdges);
  readDiagnostics(table, module);
  readRange(table, module);
  readOnStop(table, module);
  if (module.type->kind != ModuleKind::Counting) readChannels(table, module);
}

}  // namespace merker::project
