// Titles and comments of a block, its networks and statements: rows 17 to 22 of a block folder.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "s7p/code_page.h"

namespace merker::s7p {

struct StatementComment {
  std::uint32_t line = 0;  // of the network, as the editor shows it, from 0
  bool ownLine = false;    // before the statement, not behind it
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
