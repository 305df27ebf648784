// What changed in the project folder, by whoever: a browser, an editor, version control.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "workbench/project_folder.h"

namespace merker::workbench {

class FileWatch {
 public:
  // Looks at the folder. True: something is not as it was at the last look.
  bool look(const ProjectFolder& folder);
  // The CPU has now what stands there.
  void loaded() { loaded_ = seen_; }
  // The CPU is there, with its hardware, but without a program.
  void nothingLoaded();
  const std::map<std::string, Stamp>& files() const { return seen_; }
  // Sources, symbols and settings that are newer than what the CPU holds.
  std::vector<std::string> changed() const;

 private:
  std::map<std::string, Stamp> seen_, loaded_;
};

// "source", "symbols", "hardware", "table", "scenario", "other": by the name.
std::string_view kindOfFile(std::string_view path);

}  // namespace merker::workbench
