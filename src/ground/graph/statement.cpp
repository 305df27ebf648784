#include "graph/statement.h"

#include <algorithm>
#include <array>

namespace merker::graph {
namespace {

constexpr std::string_view kNames[] = {
#define OPERATION(id) #id,
#include "graph/operations.inc"
#undef OPERATION
};

}  // namespace

std::string_view name(Op op) { return kNames[static_cast<std::size_t>(op)]; }

std::optional<Op> findOp(std::string_view name) {
  const auto at = std::find(std::begin(kNames), std::end(kNames), name);
  if (at == std::end(kNames)) return std::nullopt;
  return static_cast<Op>(at - std::begin(kNames));
}

bool isJump(Op op) { return op == Op::SPA || op == Op::SPB || op == Op::SPBN || op == Op::SPBNB; }

}  // namespace merker::graph
