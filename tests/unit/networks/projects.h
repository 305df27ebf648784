// All programs of a folder: those with a merker.toml as a whole, other sources one by one.
#pragma once

#include <filesystem>
#include <functional>
#include <set>

#include "compilation/build.h"
#include "networks/source_networks.h"

namespace merker::networks {

inline Surroundings surroundingsOf(const compilation::Build& build) {
  Surroundings around;
  around.language = build.isListing() ? source::Language::Step5 : source::Language::Step7;
  around.symbols = &build.project.symbols;
  around.program = build.program.get();
  around.library = build.library.get();
  around.mnemonics = build.project.mnemonics;
  return around;
}

inline void forEachProject(const std::string& folder, const std::string& extension,
                           const std::function<void(compilation::Build)>& visit) {
  std::set<std::string> paths;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(MERKER_SOURCE_DIR "/" + folder)) {
    if (entry.path().extension() != extension) continue;
    const auto project = entry.path().parent_path() / "merker.toml";
    paths.insert(std::filesystem::exists(project) ? entry.path().parent_path().string()
                                                  : entry.path().string());
  }
  for (const std::string& path : paths) visit(compilation::build(project::load(path, ""), false));
}

}  // namespace merker::networks
