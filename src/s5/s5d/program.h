// An S5D file as a program, and a program as an S5D file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/text.h"
#include "mc5/block.h"
#include "s5d/file.h"

namespace merker::s5d {

// What did not come, or not as it stood in the file.
struct Note {
  std::string block;  // "PB 5", "record 17"; empty for the file
  std::string text;
  bool lost = true;  // false: it came in another form
};

struct Contents {
  std::string name;  // of the file
  mc5::Program program;
  // Blocks that no directory has any more; the last of each number.
  std::map<mc5::BlockId, mc5::Block> deleted;
  std::vector<Note> notes;
  bool beyondAscii = false;  // some text has characters that depend on the code page
};

// Cp437 or Cp850. Takes any bytes; a damaged block costs itself.
Contents readProgram(Bytes file, Encoding codePage);

// One file: blocks sorted, each with its pre-header and comments. `name`: up to eight characters.
// Blocks as STEP 5 counts them: 255 to a section.
std::vector<std::uint8_t> writeProgram(const mc5::Program& program, const std::string& name,
                                       Encoding codePage);

}  // namespace merker::s5d
