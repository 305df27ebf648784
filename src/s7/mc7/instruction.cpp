#include "mc7/instruction.h"

#include <algorithm>
#include <array>

namespace merker::mc7 {
namespace {

constexpr std::array kOperations{
#define OPERATION(id, de, en, status, time, source) \
  OperationInfo{#id, de, en, status, TimeClass::time, source},
#include "mc7/operations.inc"
#undef OPERATION
};

using Name = std::string_view OperationInfo::*;
using Index = std::array<std::uint8_t, kOperations.size()>;
static_assert(kOperations.size() <= 256);

// Operation numbers in the order of their mnemonics; equal ones ("O", "L") in the order of the
// table.
constexpr Index sortedBy(Name name) {
  Index index{};
  for (std::size_t i = 0; i < index.size(); ++i) index[i] = static_cast<std::uint8_t>(i);
  std::sort(index.begin(), index.end(), [name](std::uint8_t a, std::uint8_t b) {
    const int order = (kOperations[a].*name).compare(kOperations[b].*name);
    return order != 0 ? order < 0 : a < b;
  });
  return index;
}
constexpr Index kGerman = sortedBy(&OperationInfo::de);
constexpr Index kInternational = sortedBy(&OperationInfo::en);

}  // namespace

const OperationInfo& info(Operation operation) {
  return kOperations[static_cast<std::size_t>(operation)];
}

std::span<const OperationInfo> operations() { return kOperations; }

std::optional<Operation> findOperation(std::string_view mnemonic, Mnemonics mnemonics) {
  const bool german = mnemonics == Mnemonics::German;
  const Index& index = german ? kGerman : kInternational;
  const Name name = german ? &OperationInfo::de : &OperationInfo::en;
  const auto found = std::lower_bound(
      index.begin(), index.end(), mnemonic,
      [name](std::uint8_t i, std::string_view text) { return kOperations[i].*name < text; });
  if (found == index.end() || kOperations[*found].*name != mnemonic) return std::nullopt;
  return static_cast<Operation>(*found);
}

}  // namespace merker::mc7
