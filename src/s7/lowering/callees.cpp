#include "lowering/callees.h"

#include <algorithm>

namespace merker::translate {
namespace {

using mc7::Operation;

constexpr std::uint32_t kDeepest = 3;  // calls in calls
// No region has room for so many instructions: counted no further, sums of sums would overflow.
constexpr std::uint32_t kTooMany = 2 * kLongestRegion;

// Data block registers and AR2 are those of the caller again behind BE (S7-INSTR-108).
bool changesWhatReturns(const mc7::Instruction& i) {
  return i.operation == Operation::OPEN || i.operation == Operation::SWAP_DB ||
         i.operation == Operation::LAR2 || i.operation == Operation::ADD_AR2 ||
         i.operation == Operation::TAR ||
         (i.operation == Operation::TAR1 && i.operand.kind == mc7::OperandKind::AddressRegister);
}

// Nothing: back, or out of the block.
std::optional<std::uint32_t> forwards(const mc7::Listing& listing, std::uint32_t at) {
  const std::int32_t to = listing.target(listing.places[at]);
  const bool inside =
      to > static_cast<std::int32_t>(at) && static_cast<std::size_t>(to) < listing.places.size();
  return inside ? std::optional(static_cast<std::uint32_t>(to)) : std::nullopt;
}

}  // namespace

bool isCall(Operation o) { return o == Operation::UC || o == Operation::CC; }
bool isEnd(Operation o) { return o == Operation::BE || o == Operation::BEA; }

const Shape* Shapes::of(const mc7::Place& call, std::uint32_t depth) {
  const mc7::Operand& o = call.instruction.operand;
  if (!find_ || !call.known || !isCall(call.instruction.operation) || depth >= kDeepest ||
      o.kind != mc7::OperandKind::Block)
    return nullptr;
  if (o.blockKind != BlockKind::FC && o.blockKind != BlockKind::FB) return nullptr;
  const Callee* const callee = find_(o.blockKind == BlockKind::FB, o.value);
  if (callee == nullptr) return nullptr;
  if (const auto known = known_.find(callee); known != known_.end())
    return known->second ? &*known->second : nullptr;
  known_[callee] = std::nullopt;  // one that calls itself is not whole
  std::optional<Shape>& shape = known_[callee] = measure(*callee, depth);
  return shape ? &*shape : nullptr;
}

std::optional<Shape> Shapes::measure(const Callee& callee, std::uint32_t depth) {
  const mc7::Listing& listing = *callee.listing;
  const auto count = static_cast<std::uint32_t>(listing.places.size());
  if (count > kLongestCallee) return std::nullopt;
  Shape shape{.callee = &callee, .size = count, .isEntry = std::vector<std::uint8_t>(count + 1)};
  bool endsEarly = false;
  for (std::uint32_t at = 0; at < count; ++at) {
    const mc7::Place& place = listing.places[at];
    const mc7::Instruction& i = place.instruction;
    if (!place.known || functionOf(i.operation) == nullptr) return std::nullopt;
    shape.keeps |= changesWhatReturns(i);
    if (isEnd(i.operation)) continue;
    endsEarly |= i.operation == Operation::BEB;
    if (isCall(i.operation)) {
      const Shape* const called = of(place, depth + 1);
      if (called == nullptr) return std::nullopt;
      shape.size = std::min(shape.size + called->size, kTooMany);
      shape.branches |= called->branches || i.operation == Operation::CC;
      // At an exit inside of it, the registers of whoever called this block are changed, too.
      shape.keeps |= called->keeps;
    }
    if (i.operand.kind == mc7::OperandKind::JumpList) return std::nullopt;
    if (i.operand.kind != mc7::OperandKind::Jump) continue;
    const auto to = forwards(listing, at);
    if (!to) return std::nullopt;
    if (*to == at + 1) continue;
    shape.isEntry[*to] = 1;
    shape.branches |= i.operation != Operation::SPA;
  }
  if (endsEarly && shape.keeps) return std::nullopt;  // the way out of it gives nothing back
  shape.branches |= endsEarly;
  return shape;
}

}  // namespace merker::translate
