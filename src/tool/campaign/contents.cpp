#include "campaign/contents.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/text.h"
#include "project/files.h"

namespace merker::campaign {
namespace {

using project::Project;

void addFile(const Project& project, const std::string& path, std::string_view text,
             Digest& digest) {
  digest.addPart(std::filesystem::path(path).lexically_relative(project.folder).generic_string());
  digest.addPart(text);
}

void addBinary(const Project& project, const std::string& path, Digest& digest) {
  std::ifstream in(path, std::ios::binary);
  addFile(project, path, std::string(std::istreambuf_iterator<char>(in), {}), digest);
}

// GSD files have .gsd, .gse, .gsg ...: the last letter is the language.
bool isGsd(const std::string& path) {
  return path.size() > 4 && equalsIgnoreCase(path.substr(path.size() - 4, 3), ".gs");
}

}  // namespace

void addProject(const compilation::Build& build, Digest& digest) {
  const Project& project = build.project;
  for (const auto* list : {&project.otherFiles, &project.sources})
    for (const source::SourceFile& file : *list) addFile(project, file.name(), file.text(), digest);
  for (const project::MachineCode& code : project.machineCode)
    addBinary(project, code.file, digest);
  if (project::isFile(project::join(project.folder, "merker.toml")))
    for (const std::string& name : project::listFiles(project.folder))
      if (isGsd(name)) addBinary(project, project::join(project.folder, name), digest);
  if (build.partner) addProject(*build.partner, digest);
}

void addDefinition(const Definition& definition, Digest& digest) {
  const auto time = [](const std::optional<Duration>& one) {
    return one ? std::to_string(one->ns) : std::string();
  };
  digest.addPart(time(definition.time));
  digest.addPart(time(definition.start));
  digest.addPart(definition.scenario ? definition.scenario->file : "");
  digest.addPart(definition.scenario ? definition.scenario->name : "");
  for (const MeasureText& measure : definition.measures) {
    digest.addPart(measure.name);
    digest.addPart(measure.text);
    digest.addPart(measure.required ? measure.required->text : "");
  }
}

}  // namespace merker::campaign
