// The stored sources of a program: S7CONTAI.DBF and its files.
#pragma once

#include <string>
#include <vector>

#include "archive/tree.h"
#include "base/code_page.h"
#include "s7p/fault.h"

namespace merker::s7p {

struct SourceRow {
  std::string name;  // in the manager
  std::string path;  // of the tree; empty: the file is missing
  bool awl = false;  // else SCL or another language
};

std::vector<SourceRow> readSources(const archive::Tree& tree, const std::string& folder,
                                   const CodePage& page, Faults& faults);

}  // namespace merker::s7p
