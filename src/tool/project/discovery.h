// What `merker test` runs under a path: programs, each with its scenarios and whether it checks
// itself.
#pragma once

#include <string>
#include <vector>

namespace merker::project {

struct TestTarget {
  // A project folder, or one source, or the folder of all `sources`.
  std::string path;
  std::vector<std::string> sources;    // empty: `path` is a project or a single source
  std::vector<std::string> scenarios;  // files
  bool selfChecks = true;              // run //= checks, if the sources contain any
};

// Path: a project folder, a folder with such folders and loose files below it, a single source, a
// single *.scn. A *.scn belongs to the project it lies in, else to the source of the same stem
// beside it, else to all sources of its folder. Empty if nothing is found; `missing` tells whether
// the path itself does not exist.
std::vector<TestTarget> findTests(const std::string& path, bool& missing);

}  // namespace merker::project
