#include "source.h"

#include <fstream>
#include <sstream>

#include "step7/compiler.h"
#include "system/library.h"

namespace merker::differential {

namespace {

block::Program compiledAs(const std::string& name, std::string text, const CpuModel& model) {
  std::vector<source::SourceFile> sources;
  sources.emplace_back(name, std::move(text));
  const block::Program library = system::library(model);
  step7::Compilation result = step7::compile(sources, {.model = &model, .library = &library});
  return result.ok() ? std::move(result.program) : block::Program{};
}

}  // namespace

block::Program compiled(const std::string& path, const CpuModel& model) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return compiledAs(path, text.str(), model);
}

block::Program compiledText(const std::string& text, const CpuModel& model) {
  return compiledAs("text.awl", text, model);
}

const block::Program& systemCalls() {
  static const block::Program kProgram =
      compiled(MERKER_SOURCE_DIR "/tests/differential/system_calls.awl", defaultCpuModel());
  return kProgram;
}

}  // namespace merker::differential
