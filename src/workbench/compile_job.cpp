#include "workbench/compile_job.h"

namespace merker::workbench {

void CompileJob::run() {
  Offline fresh{compileProject(project_, unsaved_), {}, files_};
  const project::Project& project = fresh.build.project;
  fresh.sources = blockSources(project.sources, project.symbols);
  result_.emplace(std::move(fresh));
  done_.store(true, std::memory_order_release);
}

}  // namespace merker::workbench
