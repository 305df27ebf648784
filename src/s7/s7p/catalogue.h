// The STEP 7 projects in a tree of files, and the programs of each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "archive/tree.h"
#include "base/code_page.h"
#include "s7p/fault.h"

namespace merker::s7p {

// Folders of the tree that a program is made of; none or empty where there is none.
struct Program {
  std::string name;
  std::optional<std::string> blocks;  // with SUBBLK.DBF; "": the root of the tree
  std::string symbols;                // with SYMLIST.DBF
  std::string sources;                // with S7CONTAI.DBF
  std::string station;                // its name
  std::string cpu;                    // "CPU 315-2 DP"
};

struct Project {
  std::string name;
  std::string folder;  // of the tree; "" its root
  CodePage page;
  bool pageKnown = false;  // from its language file
  std::vector<Program> programs;
};

// "folder/path"; just the path in the root.
std::string under(const std::string& folder, const std::string& path);

// All projects, libraries and block folders that stand alone. Folders of blocks that no program has
// are programs of their own if they hold any block. `page`: instead of the code page that the
// project names.
std::vector<Project> findProjects(const archive::Tree& tree, Faults& faults, unsigned page = 0);

}  // namespace merker::s7p
