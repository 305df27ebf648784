#include "importing/look.h"

#include "importing/candidates.h"
#include "importing/recognise.h"
#include "importing/report.h"

namespace merker::importing {
namespace {

// What can lie in a project of either family.
void addLoose(const archive::Tree& tree, Contents& contents, const std::stop_token& stop) {
  for (const auto& entry : tree.files()) {
    if (stop.stop_requested()) return;
    const auto file = tree.open(entry);
    const Kind kind = file ? recognise(*file, entry.path) : Kind::Unknown;
    const bool own = file && kind == Kind::Unknown && isOwnFile(entry.path, *file);
    const bool step5 = kind == Kind::Listing || kind == Kind::Assignments;
    contents.step7 |= own || (kind != Kind::Unknown && !step5);
    contents.step5 |= own || step5 || kind == Kind::Seq;
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
  const auto merker = merkerProjects(tree, source);
  const auto step5 = step5Programs(tree, projects.empty());
  const auto programs = candidates(projects, step5, merker);
  contents.programs = labels(programs);
  for (const Candidate& one : programs) {
    contents.step7 |= one.program != nullptr;
    contents.step5 |= one.step5 != nullptr;
    contents.whole |= one.program != nullptr || one.merker != nullptr;
  }
  if (programs.empty()) addLoose(tree, contents, stop);
  contents.refused = reasons(tree);
  return contents;
}

}  // namespace merker::importing
