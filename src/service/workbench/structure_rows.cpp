#include "workbench/structure_rows.h"

#include "control/cnc.h"
#include "mc5/resident_blocks.h"
#include "monitor/program_structure.h"

namespace merker::workbench {
namespace {

// SFC and SFB of the CPU; macros and data blocks of the system of a SINUMERIK.
bool brings(const compilation::Build& build, BlockId id) {
  if (!build.isListing()) return build.library && build.library->contains(id);
  if (id.kind == BlockKind::FB) return mc5::findResident(id.number) != nullptr;
  return id.kind == BlockKind::DB &&
         sinumerik::isSystemBlock(id.number, build.project.control->plc.systemBlocks);
}

Json usedRow(const compilation::Build& build, const monitor::UsedBlock& used) {
  Json row = {{"id", toString(used.id)}};
  if (used.instance >= 0)
    row["instance"] = toString(BlockId{BlockKind::DB, static_cast<std::uint16_t>(used.instance)});
  const bool own = build.code().find(used.id).has_value();
  row["from"] = own ? "program" : brings(build, used.id) ? "cpu" : "missing";
  return row;
}

}  // namespace

Json structureRows(const compilation::Build& build) {
  const auto references = monitor::crossReferences(build.code(), build.project.symbols,
                                                   {.library = build.library.get()});
  Json list = Json::array();
  for (const monitor::BlockStructure& block : monitor::programStructure(build.code(), references)) {
    Json uses = Json::array();
    for (const monitor::UsedBlock& used : block.uses) uses.push_back(usedRow(build, used));
    Json row = {{"id", toString(block.id)}, {"uses", std::move(uses)}};
    if (block.local) row["local"] = *block.local;
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace merker::workbench
