// The program as it stands in the project folder, compiled; kept until a file changes.
#pragma once

#include <memory>

#include "compilation/build.h"
#include "workbench/block_sources.h"

namespace merker::workbench {

struct Offline {
  compilation::Build build;
  std::map<BlockId, BlockSource> sources;
  std::uint64_t files = 0;  // revision of the folder
};

// `unsaved`: texts in place of files, by their full paths.
compilation::Build compileProject(const std::string& path,
                                  const std::map<std::string, std::string>& unsaved = {});

}  // namespace merker::workbench
