#include "graph/reason.h"

namespace merker::graph {
namespace {

constexpr std::string_view kTexts[] = {
#define REASON(id, text) text,
#include "graph/reasons.inc"
#undef REASON
};

}  // namespace

std::string_view text(Reason reason) { return kTexts[static_cast<std::size_t>(reason)]; }

}  // namespace merker::graph
