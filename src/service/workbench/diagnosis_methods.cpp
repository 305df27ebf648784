// Diagnostic buffer, stacks, module information (S7-DIAG-01, S7-DIAG-04).
#include <algorithm>

#include "monitor/data_rows.h"
#include "workbench/configured_rows.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace diagnosis_methods {
namespace {

using monitor::Feature;

// block, file, line, network of a place.
void addPlace(Json& json, const monitor::SourcePlace& place, const ProjectFolder& folder) {
  json["block"] = toString(place.block);
  json["offset"] = place.offset;
  if (place.line == 0) return;
  json["file"] = folder.relative(place.file);
  json["line"] = place.line;
  json["network"] = place.network;
}

// The module at an address, where there is one; an access error says the side, others do not.
Json moduleRow(const monitor::DiagnosticLine::ModuleAddress& at, const io::Rack* rack) {
  Json row = {{"address", at.address}, {"output", at.output}};
  if (rack == nullptr) return row;
  const io::Module* module = rack->at(at.address, at.output);
  if (module == nullptr && !at.output) module = rack->at(at.address, true);
  if (module == nullptr) return row;
  row["rack"] = module->rack;
  row["slot"] = module->slotText();
  row["name"] = module->name.empty() ? module->title() : module->name;
  return row;
}

Json entryOf(const monitor::DiagnosticLine& line, const ProjectFolder& folder,
             const io::Rack* rack) {
  Json entry = {
      {"number", line.number}, {"event", line.eventText},
      {"time", line.time.ns},  {"clock", line.clock ? monitor::clockText(*line.clock) : ""},
      {"text", line.text},     {"help", line.help}};
  if (line.place) addPlace(entry, *line.place, folder);
  if (line.module) entry["module"] = moduleRow(*line.module, rack);
  return entry;
}

Answer buffer(const Call& call) {
  Json list = Json::array();
  for (const monitor::DiagnosticLine& line : call.monitor().diagnostics())
    list.push_back(entryOf(line, call.shared.folder, call.plc().rack()));
  return Json{{"entries", std::move(list)}};
}

// Those that the machine has.
Json registersOf(const monitor::Registers& r) {
  const auto block = [](std::uint16_t number) {
    return number == 0 ? std::string("-") : fmt::format("DB {}", number);
  };
  Json json = {{"AKKU1", fmt::format("{:08X}", r.accu[0])},
               {"AKKU2", fmt::format("{:08X}", r.accu[1])}};
  if (r.ar1) json["AR1"] = formatConstant({ConstantFormat::Pointer, *r.ar1});
  if (r.ar2) json["AR2"] = formatConstant({ConstantFormat::Pointer, *r.ar2});
  json["STW"] = fmt::format("{:04X}", r.word);
  json["DB"] = block(r.db);
  if (r.di) json["DI"] = block(*r.di);
  return json;
}

std::string bytesText(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes)
    text += fmt::format("{}{:02X}", text.empty() ? "" : " ", byte);
  return text;
}

// The temporary variables with their names; none of a block that is not in the program.
Json localRows(const ProgramRef& program, const monitor::LocalStackEntry& entry) {
  Json rows = Json::array();
  const auto block = program ? program->find(entry.block) : block::Program::const_iterator();
  if (!program || block == program->end()) return rows;
  for (monitor::DataValue& value : monitor::localValues(block->second, entry.bytes).values)
    rows.push_back({{"address", fmt::format("{}.{}", value.byte, value.bit)},
                    {"name", std::move(value.path)},
                    {"type", std::move(value.type)},
                    {"value", std::move(value.actual)},
                    {"comment", std::move(value.comment)}});
  return rows;
}

Answer stacks(const Call& call) {
  const monitor::Stacks all = call.monitor().stacks();
  const ProgramRef program = call.plc().program();
  const auto openText = [](std::uint16_t number) {
    return number == 0 ? std::string("-") : fmt::format("DB {}", number);
  };
  Json blocks = Json::array(), interrupts = Json::array(), locals = Json::array();
  for (const monitor::BlockStackEntry& entry : all.blocks) {
    Json row = {{"db", openText(entry.db)}, {"di", openText(entry.di)}};
    addPlace(row, entry.place, call.shared.folder);
    blocks.push_back(std::move(row));
  }
  for (const monitor::InterruptStackEntry& entry : all.interrupts) {
    Json row = {{"ob", entry.ob},
                {"priority", entry.priority},
                {"registers", registersOf(entry.registers)}};
    addPlace(row, entry.place, call.shared.folder);
    interrupts.push_back(std::move(row));
  }
  for (const monitor::LocalStackEntry& entry : all.locals)
    locals.push_back({{"block", toString(entry.block)},
                      {"bytes", bytesText(entry.bytes)},
                      {"rows", localRows(program, entry)}});
  return Json{{"blocks", std::move(blocks)},
              {"interrupts", std::move(interrupts)},
              {"locals", std::move(locals)}};
}

Answer information(const Call& call) {
  const monitor::ModuleInformation info = call.monitor().information();
  return Json{{"model", info.model},
              {"mode", monitor::name(info.mode)},
              {"stopReason", call.shared.folder.withoutFolder(info.stopReason)},
              {"clock", info.clock},
              {"memory",
               {{"loadMemory", info.loadMemory},
                {"workMemory", info.workMemory},
                {"workMemoryUsed", info.workMemoryUsed},
                {"localData", info.localData},
                {"blocks", info.blocks}}},
              {"cycle",
               {{"cycles", info.cycles},
                {"instructions", info.instructions},
                {"lastMs", info.lastCycle},
                {"shortestMs", info.shortestCycle},
                {"longestMs", info.longestCycle},
                {"monitoringMs", info.cycleMonitoring}}},
              {"limits",
               {{"inputs", info.inputs},
                {"outputs", info.outputs},
                {"flags", info.flags},
                {"timers", info.timers},
                {"counters", info.counters}}}};
}

Answer connections(const Call& call) {
  const S7Outside outside = call.shared.s7Outside();
  Json rows = s7Json(outside);
  rows["configured"] = configuredRows(call.shared, outside);
  return rows;
}

constexpr Method kMethods[] = {
    {"diagnosis.buffer", Needs::Plc, buffer},
    {"diagnosis.connections", Needs::Nothing, connections},
    {"diagnosis.stacks", Needs::able(Feature::Stacks), stacks},
    {"diagnosis.information", Needs::able(Feature::Information), information},
};

}  // namespace
}  // namespace diagnosis_methods

std::span<const Method> diagnosisMethods() { return diagnosis_methods::kMethods; }

}  // namespace merker::workbench
