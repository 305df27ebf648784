// Writes a region instruction by instruction. What registers, status bits and bytes of memory hold
// at this point is known as values here, so that a second read finds the value of the first, a
// value nobody reads is never written, and constants are computed at once.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "icode/region.h"

namespace merker::icode {

class Builder {
 public:
  // So many pure operations are remembered, to be made once: a power of two, more than the longest
  // region has.
  static constexpr std::size_t kRecent = 2048;

  explicit Builder(Region& region) : region_(&region) {
    limits_.fill(kNoValue);
    made_.fill(kNoValue);
  }

  // What always holds at the entry of the region.
  void know(Item item, bool value) { items_[index(item)] = {constant(value), false}; }
  // The machine instruction that follows.
  void begin(std::uint32_t place, std::uint64_t cost);
  // From here on it costs this instead.
  void cost(std::uint64_t ns) { cost_ = ns; }
  // It is not translated after all; it has set nothing.
  void cancel();

  Value constant(std::uint32_t number);
  std::optional<std::uint32_t> number(Value value) const;
  bool isNumber(Value value, std::uint32_t wanted) const { return number(value) == wanted; }

  // Registers and status bits as they are here, for an exit at which some of them differ.
  struct Held {
    Value value = kNoValue;
    bool dirty = false;
  };
  using Registers = std::array<Held, kItems>;
  const Registers& registers() const { return items_; }
  void restore(const Registers& registers) { items_ = registers; }

  Value get(Item item);
  void set(Item item, Value value) { items_[index(item)] = {value, true}; }
  void set(Item item, bool value) { set(item, constant(value)); }

  Value make(Opcode code, Value a = kNoValue, Value b = kNoValue, std::uint32_t number = 0);
  Value make3(Opcode code, Value a, Value b, Value c);
  Value withNumber(Opcode code, Value a, std::uint32_t number) {
    return make(code, a, kNoValue, number);
  }
  Value andBit(Value a, Value b);
  Value orBit(Value a, Value b);
  Value xorBit(Value a, Value b);
  Value notBit(Value a);
  // Of a byte.
  Value bitOf(Value byte, std::uint32_t number);
  Value withBit(Value byte, Value bit, std::uint32_t number);

  // Direct places: 1, 2 or 4 bytes.
  Value load(Space space, std::uint32_t place, unsigned bytes);
  void store(Space space, std::uint32_t place, unsigned bytes, Value value);
  // Places only known when it runs, in bytes.
  Value loadAt(Space space, Value offset, std::uint32_t place, unsigned bytes);
  void storeAt(Space space, Value offset, std::uint32_t place, unsigned bytes, Value value);
  // In bytes, of an area only known when it runs; guards the access.
  Value locate(Value area, Value bitAddress, Access access);
  Value loadFrom(Value address, unsigned bytes);
  void storeTo(Value address, unsigned bytes, Value value);
  Value limit(Space space, bool write);  // bytes of the space

  // Data blocks: from now on another one is open.
  void open(Space space, Value number, Opening wanted);
  // The registers are exchanged when someone looks at them; until then each is found in the other.
  void swapBlocks() { swapped_ = !swapped_; }
  Space held(Space space) const;
  bool isReopened(Space space) const { return reopened_[static_cast<std::size_t>(held(space))]; }
  Value blockInfo(std::uint32_t number);

  // As long as this instruction has set nothing: without bit 0 it is left to the interpreter.
  void guard(Value bit);
  bool isGuarded(Value bit) const;
  // After all that the instruction sets.
  void branch(Value bit, bool wanted, std::uint32_t to);
  void leave(std::uint32_t to);
  // The same into another block by the call of that number, and out of this one; without a
  // condition the region ends there.
  void callFrom(std::uint32_t site, std::uint32_t to, std::uint32_t front,
                Value condition = kNoValue);
  void returnFrom(std::uint32_t front, Value condition = kNoValue);
  // The state in front of this instruction, for a guard that follows behind what it sets.
  std::uint32_t front() { return exit(place_, true); }
  // A call whose block stands in the region: what follows are its instructions, until comeBack.
  void goInto(const Inlined& call, std::uint32_t front);
  void comeBack();
  // If the block changes data block registers or AR2: as they are in front of it, and again behind.
  struct Kept;
  Kept keep();
  void giveBack(const Kept& kept);
  // After all that the instruction sets, with the bit: back to the caller.
  void branchBack(Value bit);
  // The end of the region, unless the interpreter must do it.
  void call(Value number, const CallSite& site, std::uint32_t front);
  void giveBack(std::uint32_t front);

  // At the end of this instruction.
  Value timerRuns(const Cell& timer);
  Value timerUnits(std::uint32_t number);
  // Of timers and counters.
  Value field(Field field, const Cell& cell);
  void setField(Field field, const Cell& cell, Value value);

 private:
  struct Byte {
    Space space;
    std::uint32_t place;
    unsigned bytes;
    Value value;
    bool dirty;
  };
  struct FieldValue {
    Field field;
    Cell cell;
    Value value;
  };
  Value* known(Field field, const Cell& cell);
  void forgetOthers(Field field, const Cell& cell);
  static std::size_t index(Item item) { return static_cast<std::size_t>(item); }
  std::optional<std::uint32_t> folded(Opcode code, Value a, Value b, std::uint32_t number) const;
  Value lowHalf(Value value) const;
  bool isWord(Value value) const;
  bool isByte(Value value) const;
  bool isNegation(Value bit, Value of) const;
  std::optional<Value> assigned(Value& byte, std::uint32_t number) const;
  Value loaded(unsigned bytes, Value value);
  Value append(Op op);
  std::uint32_t atTheEnd() const { return static_cast<std::uint32_t>(costSoFar_ + cost_); }
  Value base(Space space);
  void settle();
  void exchangeKnown();
  void forget(Space space, std::uint32_t place, unsigned bytes);
  void writeBack(Space space, std::uint32_t place, unsigned bytes);
  void writeBackAll(Space space);
  void forgetAll(Space space);
  void storeNow(const Byte& byte);
  // In front of this instruction, or after all that were begun.
  std::uint32_t exit(std::uint32_t to, bool inFront = false);
  void leaveBy(std::uint32_t exit, Value condition);

  // The block that this region opened in a register, and what is known of it.
  struct Opened {
    Value number = kNoValue;
    Opening is{};
  };
  bool isOpen(Space space, Value number, const Opening& wanted) const;
  void act(Opcode code, Value a, std::uint32_t number, std::uint32_t place = 0);
  void reopen(Space space);

  Region* region_;
  bool swapped_ = false;
  std::array<Opened, kSpaces> opened_{};
  std::array<bool, kSpaces> reopened_{};  // these by the register that holds the block
  std::array<Value, 2 * kSpaces> limits_;
  // Pure operations made a moment ago, by a hash of what they are.
  std::array<Value, kRecent> made_;
  std::vector<Value> guarded_;  // bits that are 1 from here on
  Registers items_;
  std::array<Value, 6> bases_{kNoValue, kNoValue, kNoValue, kNoValue, kNoValue, kNoValue};
  std::vector<Byte> bytes_;
  std::vector<FieldValue> fields_;
  std::uint32_t inside_ = 0, position_ = Exit::kNoPosition;  // as in Exit
  std::uint32_t place_ = 0, executed_ = 0;                   // in front of this instruction
  std::uint64_t cost_ = 0, costSoFar_ = 0, aheadBefore_ = 0;
};

struct Builder::Kept {
  Held ar2;
  std::array<Value, 6> bases;
  std::array<Value, 2 * kSpaces> limits;
  std::array<Opened, kSpaces> opened;
  std::array<bool, kSpaces> reopened;
};

}  // namespace merker::icode
