// The program as it stands in the project folder, compiled; kept until a file changes.
#pragma once

#include <memory>
#include <stop_token>

#include "compilation/build.h"
#include "workbench/block_sources.h"

namespace merker::workbench {

struct Offline {
  std::shared_ptr<const compilation::Build> build;
  std::map<BlockId, BlockSource> sources;
  std::uint64_t files = 0;  // revision of the folder
};
// Never changed once it is there: workers look at it while the PLC goes on.
using OfflineRef = std::shared_ptr<const Offline>;

// `unsaved`: texts in place of files, by their full paths.
Offline offlineOf(const std::string& path, const std::map<std::string, std::string>& unsaved,
                  std::uint64_t files, const std::stop_token& stop);

}  // namespace merker::workbench
