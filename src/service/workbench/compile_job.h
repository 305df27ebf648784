// A compilation of a project, carried out elsewhere.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "workbench/offline.h"
#include "workbench/task.h"

namespace merker::workbench {

struct CompileJob {
  Work task;
  std::shared_ptr<Offline> result;  // when it is done
};
using Job = std::shared_ptr<CompileJob>;

// `unsaved`: texts in place of files, by their full paths. `files`: revision of the folder.
Job makeCompileJob(std::uint64_t owner, std::string project,
                   std::map<std::string, std::string> unsaved, std::uint64_t files);

}  // namespace merker::workbench
