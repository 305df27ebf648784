#include "workbench/structure_rows.h"

#include "control/cnc.h"
#include "mc5/resident_blocks.h"
#include "monitor/program_structure.h"

namespace merker::workbench {
namespace {

// SFC and SFB of the CPU; macros and data blocks of the system of a SINUMERIK.
bool brings(const compilation::Build& build, BlockId id) {
  if (!build.isListing()) {
    const bool system = id.kind == BlockKind::SFC || id.kind == BlockKind::SFB;
    return system && build.library->contains(id);
  }
  if (id.kind == BlockKind::FB) return mc5::findResident(id.number) != nullptr;
  return id.kind == BlockKind::DB &&
         sinumerik::isSystemBlock(id.number, build.project.control->plc.systemBlocks);
}

// FC 1 to FC 105 and the like, which are no part of a CPU: a CALL means them, UC and CC a block of
// the user's own (P0508).
bool isOfLibrary(const compilation::Build& build, const monitor::UsedBlock& used) {
  return used.called && !build.isListing() && build.library->contains(used.id);
}

std::string_view origin(const compilation::Build& build, const monitor::UsedBlock& used) {
  if (build.code().find(used.id)) return "program";
  if (brings(build, used.id)) return "cpu";
  return isOfLibrary(build, used) ? "library" : "missing";
}

Json usedRow(const compilation::Build& build, const monitor::UsedBlock& used) {
  Json row = {{"id", toString(used.id)}};
  if (used.instance >= 0)
    row["instance"] = toString(BlockId{BlockKind::DB, static_cast<std::uint16_t>(used.instance)});
  row["from"] = origin(build, used);
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
