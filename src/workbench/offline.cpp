#include "workbench/offline.h"

namespace merker::workbench {

compilation::Build compileProject(const std::string& path,
                                  const std::map<std::string, std::string>& unsaved) {
  auto build = compilation::build(project::load(path, {}, unsaved), false);
  compilation::requireWorkMemory(build);
  return build;
}

}  // namespace merker::workbench
