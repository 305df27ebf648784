#include "source.h"

#include <fstream>
#include <map>
#include <sstream>

#include "step7/compiler.h"
#include "system/library.h"

namespace merker::differential {

namespace {

// Made once a model: it takes longer than the programs.
const block::Program& libraryOf(const CpuModel& model) {
  static std::map<const CpuModel*, block::Program> libraries;
  const auto found = libraries.find(&model);
  return found != libraries.end() ? found->second
                                  : libraries.emplace(&model, system::library(model)).first->second;
}

block::Program compiledAs(const std::string& name, std::string text, const CpuModel& model) {
  std::vector<source::SourceFile> sources;
  sources.emplace_back(name, std::move(text));
  step7::Compilation result =
      step7::compile(sources, {.model = &model, .library = &libraryOf(model)});
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
