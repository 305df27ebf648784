// The sources of a program as one source that STEP 7 imports: callee before caller.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exporting/awl_edits.h"
#include "project/project.h"

namespace merker::exporting {

enum class Names : std::uint8_t { AsWritten, Absolute, Symbolic };

// A block with the comments before it, UTF-8, lines end with LF.
struct Piece {
  BlockId id;
  std::string text;
  std::set<BlockId> uses;  // blocks that it names
};

struct Style {
  Names names = Names::Absolute;
  bool punctuation = true;                            // add what STEP 7 wants and Merker does not
  std::optional<Mnemonics> mnemonics = std::nullopt;  // none: as written
  ParameterNames parameters = {};                     // of blocks that come without a source
};

std::vector<Piece> pieces(const project::Project& project, const Style& style);

// What a block uses stands before it, as far as blocks do not use each other; organization blocks
// last.
std::vector<Piece> ordered(std::vector<Piece> pieces);

// The mnemonics of a program's sources.
Mnemonics mnemonicsOf(const project::Project& project);

}  // namespace merker::exporting
