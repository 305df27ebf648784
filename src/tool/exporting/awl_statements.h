// The statements of a block as they stand in its source.
#pragma once

#include <string>
#include <vector>

#include "step7/block_source.h"

namespace merker::exporting {

struct Statement {
  struct Insertion {
    std::size_t at;
    std::string text;
  };
  std::size_t begin = 0, operands = 0, end = 0;  // operands: behind the mnemonic
  bool jump = false;
  std::vector<Insertion> missing;  // what STEP 7 wants and Merker does not: ; ( , )
  struct Name {
    std::size_t begin = 0, end = 0;  // with its quotation marks
    std::string text;
  };
  std::vector<Name> parameters;  // of a CALL: before :=
};

// Between BEGIN and END_…: instructions, or the assignments of a data block.
std::vector<Statement> statements(const step7::BlockSource& block);

}  // namespace merker::exporting
