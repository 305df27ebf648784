// Titles and comments of a block, its networks and statements: rows 17 to 22 of a block folder.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/code_page.h"

namespace merker::s7p {

struct StatementComment {
  // Lines of the network up to the one that it stands behind, from 1; of an own line: those before.
  std::uint32_t line = 0;
  bool ownLine = false;
  std::string text;
};

struct NetworkComments {
  std::string title, comment;
  std::vector<StatementComment> statements;
};

struct BlockComments {
  std::string title, comment;
  std::vector<NetworkComments> networks;
};

using Bytes = std::span<const std::uint8_t>;
// SSBPART, ADDINFO and MC5CODE of the row; whatever does not fit is left out.
BlockComments readComments(Bytes block, Bytes lengths, Bytes networks, const CodePage& page);

}  // namespace merker::s7p
