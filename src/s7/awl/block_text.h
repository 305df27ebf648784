// A compiled block as AWL source.
#pragma once

#include <string>
#include <vector>

#include "awl/statements.h"
#include "block/block.h"

namespace merker::awl {

struct Comment {
  // Lines of the network up to the one that it stands behind, from 1; of a comment on a line of its
  // own: those before it. A CALL is one line and one for each parameter.
  std::uint32_t line = 0;
  bool ownLine = false;
  std::string text;
};

struct NetworkText {
  std::string title, comment;
  std::vector<Comment> comments;
};

// What belongs to a source and is not in its block.
struct Texts {
  std::vector<std::string> remarks;  // comment lines before the block
  std::string declaration;           // VAR_INPUT …, STRUCT …; as declarationText without one
  std::string dataType;              // of a data block: "FB 3", "UDT 2"; empty: the declaration
  std::string returnType = "VOID";   // of a function
  std::vector<NetworkText> networks;
};

// FUNCTION FC 1 : VOID, title, attributes, declarations: up to BEGIN.
std::string headText(const block::Block& block, const Texts& texts);
std::string_view endWord(BlockKind kind);  // "END_FUNCTION"

// How calls are written: as CALL, whose temporary data lie behind those of the block, or of the
// network in a block of KOP or FUP; or as the instructions that it is made of.
enum class Form : std::uint8_t { Calls, NetworksOfKop, NetworksOfFup, Instructions };

// The whole source. `declared` is the block with the names of its variables.
std::string codeText(const block::Block& block, const block::Block& declared, const Texts& texts,
                     const Blocks& blocks, Form form);

// Lines of a comment, each behind `//`.
std::string commentLines(std::string_view text);

}  // namespace merker::awl
