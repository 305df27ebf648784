// What the sources say of their blocks. Of a block with errors that is all there is: what compiles
// of it is not what is written, so its networks come from the text.
#pragma once

#include <map>
#include <string>

#include "compilation/build.h"
#include "diagram/diagram.h"

namespace merker::diagram {

// By name, "FC 1".
struct WrittenBlocks {
  std::map<std::string, Mnemonics> mnemonics;
  std::map<std::string, BlockDiagram> faulty;
};

WrittenBlocks writtenBlocks(const compilation::Build& build);

}  // namespace merker::diagram
