#include "workbench/parameter_rows.h"

#include <algorithm>

#include "io/amount.h"
#include "workbench/axis_rows.h"
#include "workbench/counting_rows.h"
#include "workbench/parameter_row.h"
#include "workbench/serial_rows.h"

namespace merker::workbench {
namespace {

Json optional(const std::optional<std::uint32_t>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// Numbers of the bits that are set.
Json bitsOf(std::uint32_t bits) {
  Json list = Json::array();
  for (unsigned i = 0; i < 32; ++i)
    if ((bits >> i & 1) != 0) list.push_back(i);
  return list;
}

// The address counts as given where the file names it; without, it is that of the slot.
Json address(const char* key, std::uint32_t start, const Position& position) {
  return parameterRow(key, "address", start, {{"given", position.line != 0}});
}

void addDigital(const io::Module& module, Json& list) {
  const ModuleType& type = *module.type;
  const io::Parameters& parameters = module.parameters;
  if (!type.inputDelays.empty()) {
    Json choices = Json::array();
    for (const std::uint32_t delay : type.inputDelays)
      choices.push_back(io::formatLength(Duration::microseconds(delay)));
    list.push_back(parameterRow("input_delay", "choice", io::formatLength(parameters.inputDelay),
                                {{"choices", std::move(choices)}}));
  }
  if (type.digitalInputs == 0 || type.interruptChannels == 0) return;
  const Json bits = {{"count", type.digitalInputs}, {"group", type.interruptGroup}};
  list.push_back(parameterRow("rising_edge", "bits", bitsOf(parameters.risingEdges), bits));
  list.push_back(parameterRow("falling_edge", "bits", bitsOf(parameters.fallingEdges), bits));
}

void addOutputs(const io::Module& module, Json& list) {
  constexpr const char* kOnStop[] = {"zero", "keep", "substitute"};
  const io::Parameters& parameters = module.parameters;
  if (!module.type->substituteValues) return;
  list.push_back(parameterRow("on_stop", "choice",
                              kOnStop[static_cast<std::size_t>(parameters.onStop)],
                              {{"choices", kOnStop}}));
  if (parameters.onStop == io::OnStop::Substitute && module.type->digitalOutputs > 0)
    list.push_back(parameterRow("substitute", "bits", bitsOf(parameters.substituteBits),
                                {{"count", module.type->digitalOutputs}, {"group", 1}}));
}

void addInterrupts(const io::Module& module, Json& list) {
  constexpr const char* kInterrupts[] = {"none", "diagnostics", "process",
                                         "diagnostics and process"};
  const io::Parameters& parameters = module.parameters;
  if (module.type->kind == ModuleKind::Counting) {
    const std::size_t chosen =
        (parameters.diagnosticInterrupt ? 1 : 0) + (parameters.hardwareInterrupt ? 2 : 0);
    list.push_back(
        parameterRow("interrupts", "choice", kInterrupts[chosen], {{"choices", kInterrupts}}));
  } else if (module.type->diagnosticInterrupt && module.type->kind != ModuleKind::Positioning) {
    list.push_back(parameterRow("diagnostics", "flag", parameters.diagnosticInterrupt));
  }
}

Json ranges(std::uint16_t possible) {
  Json list = Json::array();
  for (const MeasuringRange& range : measuringRanges())
    if ((range.sets & possible) != 0) list.push_back(range.name);
  list.push_back("off");
  return list;
}

Json rangeRow(const MeasuringRange* range, std::uint16_t possible) {
  return parameterRow("range", "choice", range == nullptr ? "off" : range->name,
                      {{"choices", ranges(possible)}});
}

Json limitRow(const char* key, const std::optional<double>& value, const MeasuringRange& range) {
  return parameterRow(key, "amount",
                      value ? Json(io::formatAmount(*value, range.quantity)) : Json(nullptr),
                      {{"hint", io::formatAmount((range.low + range.high) / 2, range.quantity)}});
}

Json inputRows(const io::Module& module, unsigned channel) {
  const ModuleType& type = *module.type;
  const io::AnalogInput& input = module.parameters.analogInputs[channel];
  Json list = {rangeRow(input.range, type.rangesOfInput(channel))};
  if (input.range == nullptr) return list;
  if (type.wireBreakCheck && input.range->wireBreak != 0)
    list.push_back(parameterRow("wire_break", "flag", input.wireBreakCheck));
  if ((type.interruptChannels >> channel & 1) == 0) return list;
  list.push_back(limitRow("upper_limit", input.upperLimit, *input.range));
  list.push_back(limitRow("lower_limit", input.lowerLimit, *input.range));
  return list;
}

Json outputRows(const io::Module& module, unsigned channel) {
  const io::AnalogOutput& output = module.parameters.analogOutputs[channel];
  Json list = {rangeRow(output.range, module.type->outputRanges)};
  if (output.range != nullptr && module.parameters.onStop == io::OnStop::Substitute)
    list.push_back(limitRow("substitute", output.substitute, *output.range));
  return list;
}

Json milliseconds(const char* key, std::uint32_t value, const char* hint) {
  return parameterRow(key, "length", fmt::format("{}ms", value), {{"hint", hint}});
}

Json number(const char* key, Json value, std::uint32_t low, std::uint32_t high) {
  return parameterRow(key, "number", std::move(value), {{"min", low}, {"max", high}});
}

Json countingChannels(const io::Module& module, const CpuModel& model) {
  Json list = Json::array();
  const CountingType* type = countingType(model);
  if (type == nullptr) return list;
  for (std::size_t i = 0; i < type->channels.size(); ++i)
    list.push_back({{"side", "number"},
                    {"number", i},
                    {"parameters", countingRows(module.parameters.counters[i], *type)}});
  return list;
}

// [cpu.OB35], for each cyclic interrupt that the CPU has.
Json cyclicRows(const CpuModel& model, const CpuParameters& parameters) {
  Json tables = Json::array();
  for (unsigned ob = 30; ob <= 38; ++ob) {
    if (!model.hasOrganizationBlock(ob)) continue;
    const auto& all = parameters.cyclic;
    const auto given = std::ranges::find(all, ob, &CyclicParameter::ob);
    const bool set = given != all.end();
    tables.push_back(
        {{"table", fmt::format("cpu.OB{}", ob)},
         {"parameters",
          {parameterRow("interval", "length",
                        set ? Json(fmt::format("{}ms", given->interval)) : Json(),
                        {{"hint", "100ms"}}),
           parameterRow("phase", "length", set ? Json(fmt::format("{}ms", given->phase)) : Json(),
                        {{"hint", "0ms"}})}}});
  }
  return tables;
}

}  // namespace

Json parameterRows(const io::Module& module) {
  Json list = Json::array();
  list.push_back(parameterRow("name", "text", module.name));
  if (module.inputStart) list.push_back(address("input", *module.inputStart, module.inputPosition));
  if (module.outputStart)
    list.push_back(address("output", *module.outputStart, module.outputPosition));
  if (module.type->kind == ModuleKind::Interface)
    list.push_back(parameterRow("cable", "amount",
                                module.cable ? Json(fmt::format("{:g}m", *module.cable)) : Json(),
                                {{"hint", "5m"}}));
  if (module.type->kind == ModuleKind::Positioning) addAxisRows(module.parameters, list);
  addDigital(module, list);
  addInterrupts(module, list);
  addOutputs(module, list);
  if (module.type->kind == ModuleKind::PointToPoint) addSerialRows(module.parameters, list);
  return list;
}

Json channelRows(const io::Module& module, const CpuModel& model) {
  if (module.type->kind == ModuleKind::Counting) return countingChannels(module, model);
  Json list = Json::array();
  if (module.type->kind != ModuleKind::Analog) return list;
  for (unsigned i = 0; i < module.type->analogInputs; ++i)
    list.push_back({{"side", "input"}, {"number", i}, {"parameters", inputRows(module, i)}});
  for (unsigned i = 0; i < module.type->analogOutputs; ++i)
    list.push_back({{"side", "output"}, {"number", i}, {"parameters", outputRows(module, i)}});
  return list;
}

Json cpuParameterRows(const project::Project& project) {
  constexpr const char* kImageErrors[] = {"none", "each cycle", "coming and going"};
  const CpuModel& model = *project.model;
  const CpuParameters& cpu = project.parameters;
  Json list = {number("mpi_address", project.mpiAddress, 2, 126),
               milliseconds("cycle_monitoring", cpu.cycleMonitoring, "150ms"),
               milliseconds("minimum_cycle", cpu.minimumCycle, "0ms"),
               number("communication_load", cpu.communicationLoad, 10, 50),
               number("clock_memory", optional(cpu.clockMemory), 0, model.flagBytes - 1),
               number("retentive_flags", cpu.retentiveFlags, 0, model.flagBytes),
               number("retentive_timers", cpu.retentiveTimers, 0, model.timers),
               number("retentive_counters", cpu.retentiveCounters, 0, model.counters),
               parameterRow("start_on_mismatch", "flag", cpu.startOnMismatch),
               parameterRow("image_errors", "choice",
                            kImageErrors[static_cast<std::size_t>(cpu.imageErrors)],
                            {{"choices", kImageErrors}}),
               number("protection", cpu.protection, 1, 3),
               parameterRow("password", "text", cpu.password)};
  Json tables = Json::array();
  tables.push_back({{"table", "cpu"}, {"parameters", std::move(list)}});
  for (Json& table : cyclicRows(model, cpu)) tables.push_back(std::move(table));
  return tables;
}

}  // namespace merker::workbench
