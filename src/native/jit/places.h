// The register plan of one region: each value in a host register, in a slot of the stack frame, in
// the byte of an image that it is anyway, or, as a constant, nowhere. The value needed last makes
// room.
#pragma once

#include <array>
#include <vector>

#include "jit/homes.h"
#include "jit/host.h"

namespace merker::jit {

struct Spot {
  enum class Kind : std::uint8_t { None, Register, Slot, Image, Constant };
  Kind kind = Kind::None;
  std::uint32_t number = 0;  // index in kPlaces, slot, place in an image (homes.h), or the constant
};

class Places {
 public:
  Places(host::Assembler& code, const icode::Region& region, std::uint32_t slots);

  // The operation whose code is written now.
  void begin(icode::Value value) { current_ = value; }
  // What nobody needs after the current operation is free.
  void releaseDying();

  // BitOf has no place of its own: it is where the word is.
  icode::Value root(icode::Value value) const {
    const bool inWord = value != icode::kNoValue && region_.ops[value].code == icode::Opcode::BitOf;
    return inWord ? region_.ops[value].a : value;
  }
  // In a register that nobody needs after the current operation.
  bool dies(icode::Value value) const {
    return spots_[value].kind == Spot::Kind::Register && lastUse_[value] <= current_;
  }

  Spot spot(icode::Value value) const { return spots_[value]; }
  bool isConstant(icode::Value value) const { return spots_[value].kind == Spot::Kind::Constant; }
  std::uint32_t constant(icode::Value value) const { return spots_[value].number; }
  // Nobody but the next operation that is written needs the current one.
  bool isOnlyFor(icode::Value user) const { return lastUse_[current_] == user; }
  // A register that holds the value; `scratch` if it has none of its own.
  host::Gp in(icode::Value value, const host::Gp& scratch);
  host::Gp in64(icode::Value value, const host::Gp& scratch);
  // The same of what was noted earlier.
  host::Gp fetch(const Spot& spot, const host::Gp& scratch);
  // The byte there is this value.
  bool isAt(const Spot& spot, icode::Space space, std::uint32_t byte) const {
    return spot.kind == Spot::Kind::Image && spot.number == Homes::key(space, byte);
  }
  // A register for the result of the current operation.
  host::Gp out();
  // The same, with the value already in it: its own register if this is its last use.
  host::Gp outFrom(icode::Value value);
  // instruction register, value; edx is lost. With `low` only the lowest byte of the result counts.
  void apply(std::uint32_t instruction, const host::Gp& reg, icode::Value value, bool low = false);
  bool failed() const { return failed_; }

 private:
  void planUses(const icode::Region& region);
  void use(icode::Value value, std::uint32_t at);
  unsigned freePlace();
  void putAway(icode::Value value, const host::Gp& reg);
  unsigned makeRoom();
  std::uint32_t freeSlot();
  bool isArgument(icode::Value value) const;

  host::Assembler& code_;
  const icode::Region& region_;
  std::vector<Spot> spots_;
  std::vector<std::uint32_t> lastUse_;
  std::optional<Homes> homes_;  // of the first value that finds no register on
  std::array<icode::Value, kPlaceCount> owner_;
  std::vector<icode::Value> slotOwner_;  // whose last use may be over
  icode::Value current_ = 0;
  bool failed_ = false;
};

host::Mem slot(std::uint32_t number, std::uint32_t size = 4);

}  // namespace merker::jit
