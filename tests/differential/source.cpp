#include "source.h"

#include <fstream>
#include <sstream>

#include "step7/compiler.h"
#include "system/library.h"

namespace merker::differential {

block::Program compiled(const std::string& path, const CpuModel& model) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::vector<source::SourceFile> sources;
  sources.emplace_back(path, text.str());
  const block::Program library = system::library(model);
  step7::Compilation result = step7::compile(sources, {.model = &model, .library = &library});
  return result.ok() ? std::move(result.program) : block::Program{};
}

const block::Program& systemCalls() {
  static const block::Program kProgram =
      compiled(MERKER_SOURCE_DIR "/tests/differential/system_calls.awl", defaultCpuModel());
  return kProgram;
}

}  // namespace merker::differential
