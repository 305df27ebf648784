#include "station/block_copies.h"

#include <algorithm>

namespace merker::station {

using interpreter::Translated;

namespace {

// Whoever checks a block or counts its instructions wants to see each of them.
std::shared_ptr<const int> identityOf(const Translated* code) {
  return code != nullptr && code->side.empty() ? code->identity : nullptr;
}

}  // namespace

bool isSame(const std::vector<Asked>& asked, const FindCode& find) {
  return std::ranges::all_of(asked, [&find](const Asked& one) {
    return identityOf(find(one.functionBlock, one.number)) == one.identity;
  });
}

const translate::Callee* BlockCopies::callee(bool functionBlock, std::uint32_t number,
                                             std::vector<Asked>& asked) {
  const Translated* const code = find_(functionBlock, number);
  const auto identity = identityOf(code);
  const auto isThis = [&](const Asked& one) {
    return one.functionBlock == functionBlock && one.number == number;
  };
  if (std::ranges::none_of(asked, isThis)) asked.push_back({functionBlock, number, identity});
  if (identity == nullptr || code->instructionCount > translate::kLongestCallee) return nullptr;
  const auto [entry, isNew] = sources_.try_emplace(code);
  Source& source = entry->second;
  if (isNew) {
    source.listing = mc7::list(code->source->code);
    source.callee = {.listing = &source.listing,
                     .parameters = code->parameters.data(),
                     .localBytes = code->localBytes,
                     .mark = identity.get()};
  }
  return &source.callee;
}

bool callsBlocks(const Translated& code) {
  return std::ranges::any_of(code.ops, [](const interpreter::Op& op) {
    return op.kind == mc7::OperandKind::Block &&
           (op.blockKind == BlockKind::FC || op.blockKind == BlockKind::FB);
  });
}

}  // namespace merker::station
