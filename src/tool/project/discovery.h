// What `merker test` runs under a path: programs, each with its scenarios and whether it checks
// itself. What belongs to a single source.
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

// Path: a project folder with those below it, a folder with such folders and loose files below it,
// a single source, a single *.scn. A *.scn belongs to the project it lies in, else to the source of
// the same stem beside it, else to all sources of its folder. Empty if nothing is found; `missing`
// tells whether the path itself does not exist.
std::vector<TestTarget> findTests(const std::string& path, bool& missing);

// A symbol table as other tools export it, or as Merker keeps it: by its name.
bool isSymbolExport(const std::string& path);
// Symbol files of a single source, by name: those of its stem (STEP 5: PUMPE.s5 and PUMPEZ0.SEQ),
// else the only one of its folder.
std::vector<std::string> symbolsBeside(const std::string& source);

}  // namespace merker::project
