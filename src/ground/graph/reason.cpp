#include "graph/reason.h"

namespace merker::graph {
namespace {

constexpr Sentence kReasons[] = {
#define REASON(id, english, german) {english, german},
#include "graph/reasons.inc"
#undef REASON
};

}  // namespace

std::string_view text(Reason reason, Language language) {
  return kReasons[static_cast<std::size_t>(reason)].in(language);
}

}  // namespace merker::graph
