#include "importing/look.h"

#include "importing/merker_project.h"
#include "importing/recognise.h"
#include "importing/step5_material.h"
#include "s7p/catalogue.h"

namespace merker::importing {
namespace {

// What can lie in a project of either family.
void addLoose(const archive::Tree& tree, Contents& contents, const std::stop_token& stop) {
  for (const auto& entry : tree.files()) {
    if (stop.stop_requested()) return;
    const auto file = tree.open(entry);
    const Kind kind = file ? recognise(*file) : Kind::Unknown;
    contents.step7 |= kind != Kind::Unknown;
    contents.step5 |= kind == Kind::Seq;
    contents.whole |= kind == Kind::Hardware;
  }
}

}  // namespace

Contents look(const std::string& source, const std::stop_token& stop) {
  Contents contents;
  const archive::Tree tree(source);
  contents.readable = tree.readable();
  s7p::Faults faults;
  const auto projects = s7p::findProjects(tree, faults);
  for (const s7p::Project& project : projects)
    for (const s7p::Program& program : project.programs) contents.programs.push_back(program.name);
  contents.step7 = contents.whole = !contents.programs.empty();
  const auto merker = merkerProjects(tree, source);
  for (const MerkerProject& project : merker) contents.programs.push_back(project.name);
  contents.whole |= !merker.empty();
  if (merker.empty())
    for (const Step5Program& program : step5Programs(tree, projects.empty())) {
      contents.programs.push_back(program.name);
      contents.step5 = true;
    }
  if (contents.programs.empty()) addLoose(tree, contents, stop);
  return contents;
}

}  // namespace merker::importing
