// Programs of STEP 5 in a tree: S5D files with the assignment lists beside them.
#pragma once

#include <string>
#include <vector>

#include "archive/tree.h"
#include "base/text.h"
#include "importing/output.h"
#include "importing/report.h"

namespace merker::importing {

struct Step5Program {
  std::string name;  // "PUMPE" of "PUMPE@ST.S5D"
  const archive::Tree::Entry* file = nullptr;
};

// In the order of the tree; by content. Files of other names than *.S5D only with `anyName`: to
// look into each file takes its time.
std::vector<Step5Program> step5Programs(const archive::Tree& tree, bool anyName);

// The project folder of one of them. False if no block of it came. `source`: the path of the tree;
// the files beside a single file are looked for there.
bool writeStep5Project(const archive::Tree& tree, const std::string& source,
                       const Step5Program& program, Encoding codePage, Output& output,
                       Report& report);

}  // namespace merker::importing
