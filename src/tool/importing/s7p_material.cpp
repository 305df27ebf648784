#include "importing/s7p_material.h"

#include "base/code_page.h"
#include "s7p/sources.h"

namespace merker::importing {
namespace {

void readBlocks(const archive::Tree& tree, const s7p::Project& project, const std::string& folder,
                Material& material, s7p::Faults& faults) {
  s7p::Folder blocks(tree, folder, project.page, faults);
  for (const BlockId id : blocks.blocks())
    if (auto block = blocks.read(id)) material.blocks.push_back(std::move(*block));
  material.tables = blocks.variableTables();
}

void readTexts(const archive::Tree& tree, const s7p::Project& project, const std::string& folder,
               Material& material, s7p::Faults& faults, Report& report) {
  constexpr std::size_t kMegabyte = 1u << 20;
  for (const s7p::SourceRow& row : s7p::readSources(tree, folder, project.page, faults)) {
    const auto file = row.path.empty() ? nullptr : tree.open(row.path);
    if (!file) {
      report.add(Note::MissingSource, row.name);
    } else if (file->size() > source::kLargestSource * kMegabyte) {
      report.add(Note::LongSource, row.name, source::kLargestSource);
    } else {
      const std::string bytes = file->text(source::kLargestSource * kMegabyte);
      // Sources of other editors may be Unicode.
      material.sources.push_back(
          {row.name, decoded(bytes, project.page.number()).value_or(project.page.toUtf8(bytes)),
           row.awl});
    }
  }
}

}  // namespace

Material materialOf(const archive::Tree& tree, const s7p::Project& project,
                    const s7p::Program& program, Report& report) {
  Material material;
  s7p::Faults faults;
  material.name = program.name;
  material.station = program.station;
  material.cpu = program.cpu;
  material.fromProject = true;
  if (program.blocks) readBlocks(tree, project, *program.blocks, material, faults);
  if (!program.symbols.empty())
    material.symbols = s7p::readSymbols(tree, program.symbols, project.page, faults);
  if (!program.sources.empty()) readTexts(tree, project, program.sources, material, faults, report);
  for (const s7p::Fault& fault : faults) report.add(fault);
  return material;
}

}  // namespace merker::importing
