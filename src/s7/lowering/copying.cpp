#include "lowering/copying.h"

#include <algorithm>

namespace merker::translate {
namespace {

using icode::Item;
using icode::Value;
using mc7::OperandKind;
using mc7::Operation;

// What was written of a region so far, to take back what follows.
class Written {
 public:
  explicit Written(const icode::Region& r)
      : instructions_(r.instructions), ahead_(r.ahead), needs_(r.needs), sizes_{r.ops.size(),
                                                                                r.exits.size(),
                                                                                r.states.size(),
                                                                                r.bytes.size(),
                                                                                r.calls.size(),
                                                                                r.inlined.size()} {}
  void restore(icode::Region& r) const {
    r.instructions = instructions_;
    r.ahead = ahead_;
    r.needs = needs_;
    r.ops.resize(sizes_[0]);
    r.exits.resize(sizes_[1]);
    r.states.resize(sizes_[2]);
    r.bytes.resize(sizes_[3]);
    r.calls.resize(sizes_[4]);
    r.inlined.resize(sizes_[5]);
  }

 private:
  std::uint32_t instructions_;
  std::uint64_t ahead_;
  icode::Needs needs_;
  std::array<std::size_t, 6> sizes_;
};

// With the timer or counter that the caller hands over. Whoever loads a timer is noted by the
// interpreter (cpu/outlook.h).
mc7::Instruction resolved(mc7::Instruction i, const Inside& inside) {
  const bool timer = i.operand.kind == OperandKind::TimerParameter;
  if (!timer && i.operand.kind != OperandKind::CounterParameter) return i;
  if (i.operand.value >= inside.list.size()) return i;
  if (timer && (i.operation == Operation::LOAD || i.operation == Operation::LOAD_BCD)) return i;
  i.operand.kind = timer ? OperandKind::Timer : OperandKind::Counter;
  i.operand.value = inside.list[i.operand.value] >> 16;
  return i;
}

}  // namespace

bool Copying::call(const Shape& shape, const Caller& caller, std::uint32_t place) {
  own_ = caller.localBytes;
  const icode::Builder before = builder_;
  const Written written(region_);
  const std::size_t reached = reached_.size();
  const Block block{.listing = caller.listing,
                    .local = 0,
                    .localBytes = caller.localBytes,
                    .isOb = caller.isOb,
                    .parameters = caller.parameters};
  if (enter(shape, block, place)) return true;
  builder_ = before;
  written.restore(region_);
  reached_.resize(reached);
  return false;
}

void Copying::begin(const Block& block, std::uint32_t place) {
  const Operation operation = block.listing.places[place].instruction.operation;
  builder_.begin(place, means_.model.time(mc7::info(operation).time));
}

// OS 0, OR 0, STA 1, /ER 0.
void Copying::finish() {
  builder_.set(Item::Os, false);
  builder_.set(Item::Sta, true);
  builder_.set(Item::Or, false);
  builder_.set(Item::Er, false);
}

bool Copying::enter(const Shape& shape, const Block& caller, std::uint32_t place) {
  const mc7::Place& call = caller.listing.places[place];
  const Callee& callee = *shape.callee;
  begin(caller, place);
  const std::uint32_t front = builder_.front();
  const Value rlo = builder_.get(Item::Rlo);
  finish();
  if (call.instruction.operation == Operation::CC) {  // afterwards VKE is 1, called or not
    builder_.set(Item::Rlo, true);
    builder_.branch(rlo, false, place + 1);
  }
  const std::span list(caller.parameters + call.firstParameter, call.parameters);
  const Inside inside{.local = caller.local + caller.localBytes,
                      .localBytes = callee.localBytes,
                      .callerLocal = caller.local,
                      .callerLocalBytes = caller.localBytes,
                      .callerIsOb = caller.isOb,
                      .list = list};
  builder_.goInto({.outer = caller.inside,
                   .functionBlock = call.instruction.operand.blockKind == BlockKind::FB,
                   .number = call.instruction.operand.value,
                   .mark = callee.mark,
                   .offset = call.offset,
                   .resume = place + 1,
                   .list = list.data(),
                   .parameters = call.parameters,
                   .depth = caller.depth,
                   .localBytes = inside.local + callee.localBytes - own_},
                  front);
  std::optional<icode::Builder::Kept> kept;
  if (shape.keeps) kept = builder_.keep();
  const Block block{.listing = *callee.listing,
                    .local = inside.local,
                    .localBytes = callee.localBytes,
                    .isOb = false,
                    .parameters = callee.parameters,
                    .inside = static_cast<std::uint32_t>(region_.inlined.size()),
                    .depth = caller.depth + 1,
                    .here = &inside};
  const auto brackets = std::exchange(brackets_, {});
  const auto ahead = std::exchange(ahead_, {});
  if (!body(shape, block)) return false;
  brackets_ = brackets;
  ahead_ = ahead;
  if (kept) builder_.giveBack(*kept);
  builder_.comeBack();
  return true;
}

// As far as its end. False: it does not reach it.
bool Copying::body(const Shape& shape, const Block& block) {
  const auto count = static_cast<std::uint32_t>(block.listing.places.size());
  for (std::uint32_t at = 0; at < count;) {
    if (isEnd(block.listing.places[at].instruction.operation)) {
      if (!brackets_.empty()) return false;
      begin(block, at);
      finish();
      return true;
    }
    if (!instruction(shape, block, at)) return false;
  }
  return false;
}

bool Copying::instruction(const Shape& shape, const Block& block, std::uint32_t& at) {
  const mc7::Place& place = block.listing.places[at];
  if (isCall(place.instruction.operation)) {
    const Shape* const called = brackets_.empty() ? means_.shapes.of(place) : nullptr;
    return called != nullptr && enter(*called, block, at++);
  }
  if (place.instruction.operation != Operation::BEB) return lower(shape, block, at);
  begin(block, at++);
  const Value rlo = builder_.get(Item::Rlo), overflow = builder_.get(Item::Os);
  builder_.set(Item::Rlo, true);
  finish();
  builder_.branchBack(rlo);
  builder_.set(Item::Os, overflow);
  return true;
}

bool Copying::lower(const Shape& shape, const Block& block, std::uint32_t& at) {
  const mc7::Instruction instruction = resolved(block.listing.places[at].instruction, *block.here);
  const Operation operation = instruction.operation;
  begin(block, at);
  Lowering l{builder_,  region_.needs, means_.model, block.listing, at,
             brackets_, reached_,      ahead_,       block.here};
  l.known = &instruction;
  l.next = at + 1;
  l.follows = operation == Operation::SPA;
  const bool outermost = isOpening(operation) && brackets_.empty();
  if (outermost) ahead_.clear();
  if (outermost && !prepareBracket(l, shape.isEntry)) return false;
  if (!functionOf(operation)(l) || l.ended) return false;
  at = l.next;
  return true;
}

}  // namespace merker::translate
