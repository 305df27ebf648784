// What changed in the project folder, by whoever: a browser, an editor, version control.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "workbench/project_folder.h"

namespace merker::workbench {

class FileWatch {
 public:
  // What the folder looks like now. True: something is not as it was at the last look.
  bool take(Listing files);
  // The CPU has now what stands there.
  void loaded();
  // The CPU is there, with its hardware, but without a program.
  void nothingLoaded();
  const Listing& files() const { return seen_; }
  // Sources, symbols and settings that are newer than what the CPU holds, the first of them.
  const std::vector<std::string>& changed() const { return changed_; }

 private:
  void compare();

  Listing seen_, loaded_;
  std::vector<std::string> changed_;
};

// "source", "symbols", "hardware", "table", "scenario", "other": by the name.
std::string_view kindOfFile(std::string_view path);

}  // namespace merker::workbench
