#include "workbench/look.h"

#include <algorithm>

#include "block/container.h"
#include "workbench/hardware_rows.h"
#include "workbench/hardware_settings.h"
#include "workbench/program_rows.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace {

// `source` is empty for a block that has none of its own.
Json blockTexts(const monitor::ProgramCode& code, const compilation::Build& build,
                Mnemonics mnemonics) {
  const project::Project& project = build.project;
  const auto sources = build.isListing() ? listingSources(project.sources)
                                         : blockSources(project.sources, project.symbols);
  Json rows = Json::array();
  for (const monitor::BlockCode& block : code.blocks()) {
    const auto source = sources.find(block.id());
    const bool s7 = block.s7() != nullptr;
    rows.push_back({{"id", toString(block.id())},
                    {"code", listing(block, mnemonics)},
                    {"checksum", s7 ? fmt::format("{:04X}", checksum(*block.s7())) : ""},
                    {"source", source == sources.end() ? "" : source->second.text}});
  }
  return rows;
}

Json symbolTexts(const source::SymbolTable& symbols) {
  Json rows = Json::array();
  for (const source::Symbol& symbol : symbols.list())
    rows.push_back(toJson(symbolRow(symbol, symbols.language())));
  return rows;
}

// It has no modules that are chosen: the control, and its machine data unlike the standard ones.
Json controlRacks(const cnc::Options& control) {
  Json properties = Json::array();
  for (const cnc::MachineDatum& datum : control.machineData)
    properties.push_back(
        Json::array({fmt::format("MD {}", datum.number), std::to_string(datum.value)}));
  Json racks = Json::array();
  racks.push_back(
      {{"rack", 0},
       {"slots", Json::array({cpuRow("", control.model->name, std::move(properties))})}});
  return racks;
}

Json racksOf(const project::Project& project) {
  if (project.control) return controlRacks(*project.control);
  Problems none;
  const io::Configuration hardware =
      project.hardware ? *project.hardware : io::configure({}, *project.model, none);
  Json racks = hardwareRows(hardware, nullptr, project.symbols);
  addSettings(project, hardware, racks);
  return racks;
}

}  // namespace

Json lookOf(const compilation::Build& build, const block::Program* program, Mnemonics mnemonics) {
  const project::Project& project = build.project;
  const monitor::ProgramCode code = build.isListing()    ? monitor::ProgramCode(build.listings)
                                    : program != nullptr ? monitor::ProgramCode(*program)
                                                         : monitor::ProgramCode(*build.program);
  return {{"name", project.name},
          {"blocks", blockTexts(code, build, mnemonics)},
          {"symbols", symbolTexts(project.symbols)},
          {"racks", racksOf(project)}};
}

}  // namespace merker::workbench
