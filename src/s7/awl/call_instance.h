// CALL of an FB or SFB, with a data block or as multiple instance.
#pragma once

#include "awl/call_parts.h"
#include "awl/names.h"

namespace merker::awl {

// `body`: the bracket without its BLD; `call`: its UC. Empty if it has another form than the known
// ones.
std::vector<std::string> instanceCall(const Body& body, std::size_t call,
                                      const block::Block& callee, const Names& names,
                                      Mnemonics mnemonics);

}  // namespace merker::awl
