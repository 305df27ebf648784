// Ways out of a region: what holds there when it is left.
#include <algorithm>

#include "icode/builder.h"

namespace merker::icode {

void Builder::call(Value number, const CallSite& site, std::uint32_t front) {
  region_->calls.push_back(site);
  const auto which = static_cast<std::uint32_t>(region_->calls.size() - 1);
  act(Opcode::CanCall, number, front, which);
  act(Opcode::Call, number, exit(site.resume), which);
}

void Builder::giveBack(std::uint32_t front) {
  act(Opcode::CanReturn, kNoValue, front);
  swapped_ = false;  // BE gives both registers back
  act(Opcode::Return, kNoValue, exit(place_));
}

// Nothing in a region changes what makes a call possible: one look does for all of a kind.
void Builder::goInto(const Inlined& call, std::uint32_t front) {
  const auto same = [&call](const Inlined& other) {
    return other.functionBlock == call.functionBlock && other.number == call.number &&
           other.depth >= call.depth && other.localBytes >= call.localBytes;
  };
  const bool isChecked = std::any_of(region_->inlined.begin(), region_->inlined.end(), same);
  region_->inlined.push_back(call);
  const auto which = static_cast<std::uint32_t>(region_->inlined.size());
  if (!isChecked) act(Opcode::CanInline, kNoValue, front, which - 1);
  inside_ = which;
  position_ = call.offset;
}

void Builder::comeBack() { inside_ = region_->inlined[inside_ - 1].outer; }

// The frame is not there yet, but its place is (CanInline).
Builder::Kept Builder::keep() {
  settle();
  const Value ar2 = get(Item::Ar2);
  region_->inlined[inside_ - 1].keeps = true;
  act(Opcode::KeepFrame, ar2, 0, inside_ - 1);
  return {items_[index(Item::Ar2)], bases_, limits_, opened_, reopened_};
}

void Builder::giveBack(const Kept& kept) {
  swapped_ = false;
  act(Opcode::GiveBack, kNoValue, 0, inside_ - 1);
  items_[index(Item::Ar2)] = kept.ar2;
  bases_ = kept.bases;
  limits_ = kept.limits;
  opened_ = kept.opened;
  reopened_ = kept.reopened;
  forgetAll(Space::Data);  // what it wrote it wrote through other registers
}

void Builder::branchBack(Value bit) {
  const std::uint32_t here = inside_, to = region_->inlined[here - 1].resume;
  comeBack();
  branch(bit, true, to);
  inside_ = here;
}

std::uint32_t Builder::exit(std::uint32_t to, bool inFront) {
  Exit out;
  out.to = to;
  out.instructions = inFront ? executed_ : region_->instructions;
  out.cost = inFront ? costSoFar_ : costSoFar_ + cost_;
  out.swapped = swapped_;
  out.inside = inside_;
  out.position = position_;
  out.firstState = static_cast<std::uint32_t>(region_->states.size());
  for (unsigned i = 0; i < kItems; ++i)
    if (items_[i].dirty) region_->states.push_back({static_cast<Item>(i), items_[i].value});
  out.states = static_cast<std::uint32_t>(region_->states.size()) - out.firstState;
  out.firstByte = static_cast<std::uint32_t>(region_->bytes.size());
  for (const Byte& byte : bytes_)
    if (byte.dirty) region_->bytes.push_back({byte.space, byte.place, byte.value});
  out.bytes = static_cast<std::uint32_t>(region_->bytes.size()) - out.firstByte;
  region_->exits.push_back(out);
  return static_cast<std::uint32_t>(region_->exits.size() - 1);
}

bool Builder::isGuarded(Value bit) const {
  return std::find(guarded_.begin(), guarded_.end(), bit) != guarded_.end();
}

void Builder::guard(Value bit) {
  if (isNumber(bit, 1) || isGuarded(bit)) return;
  guarded_.push_back(bit);
  append({.code = Opcode::Guard, .a = bit, .number = exit(place_, true)});
}

void Builder::branch(Value bit, bool wanted, std::uint32_t to) {
  const Opcode code = wanted ? Opcode::BranchIf : Opcode::BranchUnless;
  append({.code = code, .a = bit, .number = exit(to)});
}

void Builder::callFrom(std::uint32_t site, std::uint32_t to, std::uint32_t front, Value condition) {
  const std::uint32_t out = exit(to);
  region_->exits[out].way = Way::Call;
  region_->exits[out].site = site;
  region_->exits[out].front = front;
  leaveBy(out, condition);
}

void Builder::returnFrom(std::uint32_t front, Value condition) {
  const std::uint32_t out = exit(place_);
  region_->exits[out].way = Way::Return;
  region_->exits[out].front = front;
  leaveBy(out, condition);
}

void Builder::leaveBy(std::uint32_t out, Value condition) {
  if (condition == kNoValue)
    append({.code = Opcode::Leave, .number = out});
  else
    append({.code = Opcode::BranchIf, .a = condition, .number = out});
}

void Builder::leave(std::uint32_t to) { append({.code = Opcode::Leave, .number = exit(to)}); }

}  // namespace merker::icode
