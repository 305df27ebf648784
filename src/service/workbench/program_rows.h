// Blocks, comparison, cross reference as rows of answers.
#pragma once

#include "monitor/cross_reference.h"
#include "workbench/json.h"
#include "workbench/offline.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

// `sources`: where the blocks stand.
Json blockRows(const mc5::Program& program, const project::Project& project,
               const ProjectFolder& folder);
// `cpu`: as they are in it.
Json blockRows(const block::Program& program, const std::map<BlockId, BlockSource>& sources,
               const ProjectFolder& folder, bool cpu);
// Where the compiler has put the variables of each block (S7-EDIT-02).
Json interfaceRows(const block::Program& program, const std::map<BlockId, BlockSource>& sources,
                   const ProjectFolder& folder);
Json comparison(const block::Program& offline, const block::Program& online);
Json comparison(const mc5::Program& offline, const mc5::Program& online);
Json referenceRows(const std::vector<monitor::CrossReference>& list, const ProjectFolder& folder);
// What an editor can complete: symbols, blocks, instructions.
Json completion(const compilation::Build& build);
// Machine code as instructions; of a data block its values.
std::string listing(const monitor::BlockCode& code, Mnemonics mnemonics);
// `source`: of the block, null if it has none.
Json machineCodeRows(const monitor::BlockCode& code, Mnemonics mnemonics, const BlockSource* source,
                     const ProjectFolder& folder);

}  // namespace merker::workbench
