#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "monitor_text.h"

namespace merker::app {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const auto& value) { return value ? Json(*value) : Json(nullptr); }

Json registers(const monitor::Registers& r) {
  return {{"akku1", r.accu[0]}, {"akku2", r.accu[1]},   {"akku3", r.accu[2]},
          {"akku4", r.accu[3]}, {"ar1", orNull(r.ar1)}, {"ar2", orNull(r.ar2)},
          {"stw", r.word},      {"vke", r.rlo},         {"sta", r.sta},
          {"db", r.db},         {"di", orNull(r.di)}};
}

// Priorities and MCR are those of an S7, which has a DI.
Json interrupt(const monitor::InterruptStackEntry& entry) {
  const bool s7 = entry.registers.di.has_value();
  return {{"ob", entry.ob},
          {"priority", s7 ? Json(entry.priority) : Json(nullptr)},
          {"error_ob", entry.errorOb},
          {"place", toJson(entry.place)},
          {"registers", registers(entry.registers)},
          {"brackets", entry.brackets.size()},
          {"mcr", s7 ? Json(entry.mcr.size()) : Json(nullptr)}};
}

// Null: the machine has none.
Json orNone(std::uint32_t value) { return value == 0 ? Json(nullptr) : Json(value); }

Json cycleTimes(const monitor::ModuleInformation& info) {
  if (!info.raster)
    return {
        {"last", info.lastCycle}, {"shortest", info.shortestCycle}, {"longest", info.longestCycle}};
  return {{"raster", static_cast<double>(info.raster->length.ns) / 1e6},
          {"program", static_cast<double>(info.raster->runTime.ns) / 1e6},
          {"monitoring", info.cycleMonitoring}};
}

}  // namespace

Json toJson(const monitor::SourcePlace& place) {
  return {{"block", toString(place.block)},
          {"offset", place.offset},
          {"file", place.file},
          {"line", place.line},
          {"network", place.network}};
}

Json toJson(const monitor::Stacks& stacks) {
  Json result = {
      {"blocks", Json::array()}, {"interrupts", Json::array()}, {"locals", Json::array()}};
  for (const monitor::BlockStackEntry& entry : stacks.blocks)
    result["blocks"].push_back({{"place", toJson(entry.place)},
                                {"db", entry.db},
                                {"di", stacks.withoutDi() ? Json(nullptr) : Json(entry.di)}});
  for (const monitor::InterruptStackEntry& entry : stacks.interrupts)
    result["interrupts"].push_back(interrupt(entry));
  for (const monitor::LocalStackEntry& entry : stacks.locals)
    result["locals"].push_back({{"block", toString(entry.block)}, {"bytes", entry.bytes}});
  return result;
}

Json toJson(const std::vector<monitor::DiagnosticLine>& lines) {
  Json list = Json::array();
  for (const monitor::DiagnosticLine& line : lines) {
    Json row = {{"number", line.number},
                {"clock", line.clock ? Json(monitor::clockText(*line.clock)) : Json(nullptr)},
                {"seconds", static_cast<double>(line.time.ns) / 1e9},
                {"event", line.eventText},
                {"text", line.text}};
    if (!line.help.empty()) row["help"] = line.help;
    if (line.place) row["place"] = toJson(*line.place);
    list.push_back(std::move(row));
  }
  return list;
}

Json toJson(const monitor::ModuleInformation& info) {
  return {{"model", info.model},
          {"mode", monitor::name(info.mode)},
          {"fault", info.fault},
          {"stop_reason", info.stopReason},
          {"seconds", static_cast<double>(info.time.ns) / 1e9},
          {"clock", info.clock.empty() ? Json(nullptr) : Json(info.clock)},
          {"cycles", info.cycles},
          {"instructions", info.instructions},
          {"cycle_ms", cycleTimes(info)},
          {"blocks", info.blocks},
          {"load_memory", orNone(info.loadMemory)},
          {"work_memory", {{"used", info.workMemoryUsed}, {"size", info.workMemory}}},
          {"local_data", orNone(info.localData)}};
}

}  // namespace merker::app
