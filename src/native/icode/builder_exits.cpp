// Ways out of a region: what holds there when it is left.
#include <algorithm>

#include "icode/builder.h"

namespace merker::icode {

void Builder::call(Value number, const CallSite& site, std::uint32_t front) {
  region_.calls.push_back(site);
  const auto which = static_cast<std::uint32_t>(region_.calls.size() - 1);
  act(Opcode::CanCall, number, front, which);
  act(Opcode::Call, number, exit(site.resume), which);
}

void Builder::giveBack(std::uint32_t front) {
  act(Opcode::CanReturn, kNoValue, front);
  swapped_ = false;  // BE gives both registers back
  act(Opcode::Return, kNoValue, exit(place_));
}

std::uint32_t Builder::exit(std::uint32_t to, bool inFront) {
  Exit out;
  out.to = to;
  out.instructions = inFront ? executed_ : region_.instructions;
  out.cost = inFront ? costSoFar_ : costSoFar_ + cost_;
  out.swapped = swapped_;
  out.firstState = static_cast<std::uint32_t>(region_.states.size());
  for (unsigned i = 0; i < kItems; ++i)
    if (items_[i].dirty) region_.states.push_back({static_cast<Item>(i), items_[i].value});
  out.states = static_cast<std::uint32_t>(region_.states.size()) - out.firstState;
  out.firstByte = static_cast<std::uint32_t>(region_.bytes.size());
  for (const Byte& byte : bytes_)
    if (byte.dirty) region_.bytes.push_back({byte.space, byte.place, byte.value});
  out.bytes = static_cast<std::uint32_t>(region_.bytes.size()) - out.firstByte;
  region_.exits.push_back(out);
  return static_cast<std::uint32_t>(region_.exits.size() - 1);
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
  region_.exits[out].way = Way::Call;
  region_.exits[out].site = site;
  region_.exits[out].front = front;
  leaveBy(out, condition);
}

void Builder::returnFrom(std::uint32_t front, Value condition) {
  const std::uint32_t out = exit(place_);
  region_.exits[out].way = Way::Return;
  region_.exits[out].front = front;
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
