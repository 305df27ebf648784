#include "importing/candidates.h"

#include <algorithm>
#include <map>

#include "base/text.h"

namespace merker::importing {
namespace {

// "Plant/SIMATIC 300(1)/S7 Program(1)"; what is empty is left out.
std::string joined(const std::vector<std::string_view>& parts) {
  std::string path;
  for (const std::string_view part : parts)
    if (!part.empty()) path += (path.empty() ? "" : "/") + std::string(part);
  return path;
}

// As the manager shows where it lies.
std::string managerPath(const Candidate& one) {
  if (one.program != nullptr)
    return joined({one.project->name, one.program->station, one.program->cpu, one.name});
  return one.step5 != nullptr ? one.step5->file->path : one.merker->folder;
}

// As it lies in the source.
std::string sourcePath(const Candidate& one) {
  return one.program == nullptr ? managerPath(one)
                                : joined({one.project->folder, managerPath(one)});
}

std::map<std::string, int> counted(const std::vector<Candidate>& list) {
  std::map<std::string, int> counts;
  for (const Candidate& one : list) ++counts[upper(one.label)];
  return counts;
}

void lengthen(std::vector<Candidate>& list, std::string (*path)(const Candidate&)) {
  const auto counts = counted(list);
  for (Candidate& one : list)
    if (counts.at(upper(one.label)) > 1) one.label = path(one);
}

void number(std::vector<Candidate>& list) {
  std::map<std::string, int> counts;
  for (Candidate& one : list)
    if (const int count = ++counts[upper(one.label)]; count > 1)
      one.label += fmt::format(" #{}", count);
}

}  // namespace

std::vector<Candidate> candidates(const std::vector<s7p::Project>& projects,
                                  const std::vector<Step5Program>& step5,
                                  const std::vector<MerkerProject>& merker) {
  std::vector<Candidate> list;
  for (const s7p::Project& project : projects)
    for (const s7p::Program& program : project.programs)
      list.push_back({program.name, program.name, &project, &program, nullptr, nullptr});
  for (const MerkerProject& project : merker)
    list.push_back({project.name, project.name, nullptr, nullptr, nullptr, &project});
  if (merker.empty())
    for (const Step5Program& program : step5)
      list.push_back({program.name, program.name, nullptr, nullptr, &program, nullptr});
  lengthen(list, managerPath);
  lengthen(list, sourcePath);
  number(list);
  return list;
}

std::vector<std::string> labels(const std::vector<Candidate>& list) {
  std::vector<std::string> names;
  for (const Candidate& one : list) names.push_back(one.label);
  return names;
}

std::vector<Candidate> chosenOf(const std::vector<Candidate>& list, std::string_view wanted) {
  if (wanted.empty()) return list;
  const auto fitting = [&](std::string Candidate::*part) {
    std::vector<Candidate> some;
    std::ranges::copy_if(list, std::back_inserter(some),
                         [&](const Candidate& one) { return equalsIgnoreCase(one.*part, wanted); });
    return some;
  };
  if (auto one = fitting(&Candidate::label); !one.empty()) return one;
  auto some = fitting(&Candidate::name);
  return some.size() == 1 ? some : std::vector<Candidate>{};
}

}  // namespace merker::importing
