#include "importing/project_writer.h"

#include <algorithm>

#include "catalogue/cpu_model.h"
#include "importing/hardware.h"
#include "importing/retranslation.h"
#include "importing/symbol_rows.h"
#include "s5project/project.h"
#include "source/symbol_text.h"
#include "system/library.h"

namespace merker::importing {
namespace {

std::string fileName(BlockId id) { return fmt::format("{}{}", name(id.kind), id.number); }

struct Counts {
  std::size_t all = 0, stored = 0, disassembled = 0, machineCode = 0;
};

void count(const BlockFile& file, Counts& counts) {
  ++counts.all;
  if (file.origin == Origin::Stored) ++counts.stored;
  if (file.origin == Origin::Disassembled) ++counts.disassembled;
  if (file.origin == Origin::MachineCode) ++counts.machineCode;
}

void writeSources(const Material& material, Retranslation& blocks, Output& output, Report& report) {
  for (const TextFile& source : material.sources) {
    if (source.awl && blocks.offer(source)) continue;
    report.add(source.awl ? Note::UnusedSource : Note::ForeignSource, source.name);
    output.write("sources/" + output.unused(source.name, ".txt"), source.text);
  }
}

void writeBlocks(const Material& material, const step7::CompileOptions& options, Output& output,
                 Report& report) {
  Retranslation blocks(material, options, report);
  writeSources(material, blocks, output, report);
  Counts counts;
  for (const s7p::StoredBlock& stored : material.blocks) {
    if (output.stopped()) return;
    const BlockId id = stored.block.id;
    if (isOfTheCpu(id, *options.library) || stored.damaged) continue;
    const BlockFile file = blocks.write(stored);
    count(file, counts);
    if (!file.text.empty()) output.write(fileName(id) + ".awl", file.text);
    if (!file.container.empty())
      output.write(fileName(id) + ".mc7", std::span<const std::uint8_t>(file.container));
  }
  if (counts.all > 0)
    report.add(Note::Blocks, counts.stored + counts.disassembled, counts.all, counts.stored,
               counts.disassembled, counts.machineCode);
}

void writeTables(const Material& material, Output& output, Report& report) {
  for (const s7p::VariableTable& table : material.tables) {
    std::string text = "// operand ; format ; modify value\n";
    for (const std::string& operand : table.operands) text += operand + "\n";
    output.write(fmt::format("VAT{}.vat", table.number), text);
    report.add(Note::TableFormats, table.number);
    if (table.unknown > 0) report.add(Note::TableRows, table.number, table.unknown);
  }
  if (!material.tables.empty()) report.add(Note::VariableTables, material.tables.size());
}

void writeFiles(const Material& material, Output& output, Report& report) {
  for (const TextFile& file : material.files) {
    const std::size_t point = file.name.rfind('.');
    const std::string name = output.unused(file.name.substr(0, point), file.name.substr(point));
    if (name != file.name) report.add(Note::Renamed, file.name, name);
    if (output.write(name, file.text)) report.add(Note::Listing, name);
  }
}

}  // namespace

void writeProject(const Material& material, Output& output, Report& report) {
  if (material.step5 && material.model.empty()) {
    output.write("merker.toml", s5project::settings(material.name, "a listing"));
    return writeFiles(material, output, report);
  }
  if (!material.station.empty() || !material.cpu.empty())
    report.add(Note::Station, material.station, material.cpu);
  const std::string model = material.model.empty() ? modelOf(material, report) : material.model;
  output.write("merker.toml", settingsText(material, model, report));
  if (material.modulesLeftOut > 0) report.add(Note::ModulesLeftOut, material.modulesLeftOut);
  if (material.fromProject && !material.cpu.empty()) report.add(Note::NoAddresses);

  const source::SymbolTable symbols = tableOf(material.symbols, report);
  if (!symbols.list().empty()) {
    output.write("symbols.sym", source::writeSymbols(symbols, ".sym", Mnemonics::German));
    report.add(Note::Symbols, symbols.list().size());
  }
  step7::CompileOptions options;
  options.model = findCpuModel(model);
  const block::Program library = system::library(*options.model);
  options.library = &library;
  options.symbols = &symbols;
  writeBlocks(material, options, output, report);
  writeFiles(material, output, report);
  for (const TextFile& file : material.foreign)
    output.write("sources/" + output.unused(file.name, ".txt"), file.text);
  writeTables(material, output, report);
}

}  // namespace merker::importing
