#include "workbench/compile_job.h"

namespace merker::workbench {

Job makeCompileJob(std::uint64_t owner, std::string project,
                   std::map<std::string, std::string> unsaved, std::uint64_t files) {
  auto job = std::make_shared<CompileJob>();
  job->result = std::make_shared<Offline>();
  job->result->files = files;
  job->task =
      std::make_shared<Task>(owner, [project = std::move(project), unsaved = std::move(unsaved),
                                     result = job->result](const std::stop_token& stop) {
        *result = offlineOf(project, unsaved, result->files, stop);
      });
  return job;
}

}  // namespace merker::workbench
