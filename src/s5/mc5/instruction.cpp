#include "mc5/instruction.h"

#include <array>

namespace merker::mc5 {
namespace {

constexpr std::array kOperations{
#define OPERATION(id, name, other, level, status, source) \
  OperationInfo{#id, name, other, Level::level, status, source},
#include "mc5/operations.inc"
#undef OPERATION
};

}  // namespace

const OperationInfo& info(Operation operation) {
  return kOperations[static_cast<std::size_t>(operation)];
}

std::span<const OperationInfo> operations() { return kOperations; }

}  // namespace merker::mc5
