#include "station/senders.h"

#include <algorithm>

#include "mc7/disassembly.h"

namespace merker::station {
namespace {

// SFC 60, 61: global data; 65 to 69, 72 to 74: basic communication (System Software for
// S7-300/400, chapters 21 and 22). 71 stands between them and does not exist.
bool sends(BlockId id) { return id.kind == BlockKind::SFC && id.number >= 60 && id.number <= 74; }

}  // namespace

bool Senders::in(const std::shared_ptr<const block::Program>& program) {
  if (program == seen_) return found_;
  seen_ = program;
  found_ = program && std::ranges::any_of(*program, [](const auto& entry) {
             return std::ranges::any_of(mc7::calledBlocks(entry.second.code), sends);
           });
  return found_;
}

}  // namespace merker::station
