#include "workbench/offline.h"

namespace merker::workbench {

Offline offlineOf(const std::string& path, const std::map<std::string, std::string>& unsaved,
                  std::uint64_t files, const std::stop_token& stop) {
  auto build = std::make_shared<compilation::Build>(
      compilation::build(project::load(path, {}, unsaved, stop), false));
  Offline offline{build, {}, files};
  if (stop.stop_requested()) return offline;
  compilation::requireWorkMemory(*build);
  offline.sources = blockSources(build->project.sources, build->project.symbols);
  return offline;
}

}  // namespace merker::workbench
