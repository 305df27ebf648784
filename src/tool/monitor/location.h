// Places in the program as a user names them: FC 1, FC 1:12, plant.awl:20, 20, FC 1 network 2,
// FC 1 byte 6, of STEP 5 PB 5 word 6, "Motor":20, of STEP 5 -MOTOR:20.
#pragma once

#include <string_view>

#include "base/result.h"
#include "monitor/code_map.h"
#include "source/symbol_table.h"

namespace merker::monitor {

struct LocationContext {
  ProgramCode program;
  const source::SymbolTable& symbols;
  std::string currentFile;  // what a bare line number means
};

// The first statement at or behind the place. P1201 to P1204 say what is wrong.
Result<SourcePlace> findLocation(std::string_view text, const LocationContext& context);
// "FC 1", "fc1", "\"Motor\"", "-MOTOR": a block of the program.
Result<BlockId> findBlock(std::string_view text, const LocationContext& context);

}  // namespace merker::monitor
