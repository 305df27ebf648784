// The intermediate code. A region is a piece of a block with one entry and no way back into it:
// values are defined once, status bits and condition codes among them, and nothing is written to
// the registers of the CPU before an exit, which says what stands where by then.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace merker::icode {

enum class Opcode : std::uint8_t {
#define ICODE(id, text, result, arguments, effect) id,
#include "icode/icode.inc"
#undef ICODE
};

enum class Result : std::uint8_t { Nothing, Bit, Word, Address };
enum class Effect : std::uint8_t { Pure, Reads, Acts };

struct OpcodeInfo {
  std::string_view text;
  Result result;
  std::uint8_t arguments;
  Effect effect;
};
const OpcodeInfo& info(Opcode opcode);

// Registers and status bits.
enum class Item : std::uint8_t {
  Accu1,
  Accu2,
  Accu3,
  Accu4,
  Ar1,
  Ar2,
  Er,
  Rlo,
  Sta,
  Or,
  Os,
  Ov,
  Cc0,
  Cc1,
  Br
};
constexpr unsigned kItems = 15;
constexpr bool isBit(Item item) { return item >= Item::Er; }

enum class Space : std::uint8_t { Input, Output, Flag, Data, Instance, Local };
constexpr unsigned kSpaces = 6;
constexpr bool isImage(Space space) { return space <= Space::Flag; }

// Of a timer or counter. Bits and numbers of a byte each, but for the two of isWord.
enum class Field : std::uint8_t {
  TimerKind,
  TimerStartEdge,
  TimerEnableEdge,
  TimerStarted,
  TimerHeld,
  TimerBase,
  TimerFrozen,
  CounterCount,
  CounterSetEdge,
  CounterUpEdge,
  CounterDownEdge,
  CounterEnableEdge
};
constexpr unsigned kFields = 12;
// What FieldByte gives for TimerKind.
enum class TimerKind : std::uint8_t { Pulse, ExtendedPulse, OnDelay, StoredOnDelay, OffDelay };
constexpr bool isTimer(Field field) { return field < Field::CounterCount; }
constexpr bool isWord(Field field) {
  return field == Field::TimerFrozen || field == Field::CounterCount;
}
constexpr bool isNumber(Field field) { return isWord(field) || field == Field::TimerBase; }

using Value = std::uint32_t;  // number of the operation that makes it
constexpr Value kNoValue = UINT32_MAX;

// A timer or counter by its number, or by the value that is its number when the region runs; the
// CPU has it.
struct Cell {
  std::uint32_t number = 0;
  Value value = kNoValue;
  bool isDirect() const { return value == kNoValue; }
  bool operator==(const Cell&) const = default;
};

struct Op {
  Opcode code = Opcode::Constant;
  Space space = Space::Input;
  Item item = Item::Accu1;
  bool needed = true;  // false: nobody reads it (optimiser)
  bool late = false;   // only exits read it: computed there (optimiser)
  Value a = kNoValue, b = kNoValue, c = kNoValue;
  std::uint32_t number = 0;  // constant, bit, shift, number of a timer; ways out: which exit
  std::uint32_t place = 0;   // byte of the space
  bool operator==(const Op&) const = default;
};

// `place` of Locate.
struct Access {
  unsigned bytes = 1;
  bool whole = false;  // only at bit 0
  bool write = false;
  std::uint32_t packed() const { return bytes | (whole ? 8u : 0u) | (write ? 16u : 0u); }
  static Access of(std::uint32_t p) { return {p & 7, (p & 8) != 0, (p & 16) != 0}; }
};

// `place` of Open: what the block must have, and whether the other register first takes over what
// this one holds.
struct Opening {
  std::uint32_t bytes = 0;
  bool write = false;
  bool moves = false;
  std::uint32_t packed() const { return bytes << 2 | (write ? 1u : 0u) | (moves ? 2u : 0u); }
  static Opening of(std::uint32_t p) { return {p >> 2, (p & 1) != 0, (p & 2) != 0}; }
};

struct StateWrite {
  Item item;
  Value value;
};
// A byte of the process image or flags that so far is only a value.
struct ByteWrite {
  Space space;
  std::uint32_t place;
  Value value;
};

// Where an exit leads: on in the block, into another one, which comes back to `to`, or out of it.
enum class Way : std::uint8_t { On, Call, Return };

struct Exit {
  std::uint32_t to = 0;            // instruction of the block with which it goes on
  std::uint32_t instructions = 0;  // executed so far
  std::uint64_t cost = 0;          // ns, of these
  std::uint32_t firstState = 0, states = 0;
  std::uint32_t firstByte = 0, bytes = 0;
  bool swapped = false;  // DB and DI register are still to be exchanged
  Way way = Way::On;
  std::uint32_t site = 0;   // of the call
  std::uint32_t front = 0;  // exit instead of it, if the block stack does not allow that way
  // In a block that stands in the region (Region::inlined, counted from 1): its frame, and those of
  // its callers as far as they stand there, are written now.
  std::uint32_t inside = 0;
  // Of the call that came last and stands in the region; kNoPosition: none.
  std::uint32_t position = kNoPosition;
  static constexpr std::uint32_t kNoPosition = UINT32_MAX;
};

// UC or CC with what stands behind it.
struct CallSite {
  bool functionBlock = false;
  std::uint32_t offset = 0;  // of the instruction in its block, bytes
  std::uint32_t resume = 0;  // instruction behind it
  std::uint32_t firstParameter = 0, parameters = 0;
};

// A call whose block stands in the region with its instructions.
struct Inlined {
  std::uint32_t outer = 0;  // in which it is called, as Exit::inside
  bool functionBlock = false;
  std::uint32_t number = 0;    // of the block
  const void* mark = nullptr;  // what the block carries as long as its instructions are these
  std::uint32_t offset = 0;    // of the call in its block, bytes
  std::uint32_t resume = 0;    // instruction behind it
  const std::uint32_t* list = nullptr;  // behind the call
  std::uint32_t parameters = 0;         // entries of it
  std::uint32_t depth = 0;              // frames that are not written, without its own
  std::uint32_t localBytes = 0;         // local data of all these and its own
  bool keeps = false;                   // its frame has what the caller gets back (KeepFrame)
};

// What must hold at the entry; otherwise the interpreter goes through the region.
struct Needs {
  std::uint32_t dataRead = 0, dataWritten = 0;  // bytes of the open data block
  std::uint32_t instanceRead = 0, instanceWritten = 0;
  std::uint32_t local = 0;
  std::uint32_t parameters = 0;  // entries of the list behind the call
  bool relayOn = false;          // master control relay
  bool noBrackets = false;       // none open, in no level
};

struct Region {
  std::uint32_t first = 0;         // instruction of the block with which it begins
  std::uint32_t instructions = 0;  // on the straight way
  // ns of all instructions but the last: the clock must not reach the horizon before that one.
  std::uint64_t ahead = 0;
  Needs needs;
  std::vector<Op> ops;
  std::vector<Exit> exits;
  std::vector<StateWrite> states;
  std::vector<ByteWrite> bytes;
  std::vector<CallSite> calls;
  std::vector<Inlined> inlined;
};

// What `op` may leave the region by; nothing if it is no way out.
class ExitsOf {
 public:
  ExitsOf(const Region& region, const Op& op) {
    if (op.code < Opcode::Guard || op.code == Opcode::KeepFrame || op.code == Opcode::GiveBack)
      return;
    exits_[count_++] = op.number;
    if (op.number >= region.exits.size()) return;
    const Exit& exit = region.exits[op.number];
    if (exit.way != Way::On) exits_[count_++] = exit.front;
  }
  const std::uint32_t* begin() const { return exits_.data(); }
  const std::uint32_t* end() const { return exits_.data() + count_; }

 private:
  std::array<std::uint32_t, 2> exits_{};
  std::size_t count_ = 0;
};

// The result of a pure operation on numbers; `b` is the second one, or `number` of the operation.
// Nothing if it is not computed before it runs.
std::optional<std::uint32_t> fold(Opcode code, std::uint32_t a, std::uint32_t b);

// Drops what nobody reads: dead flags, dead accumulators.
void optimise(Region& region);
// What is wrong with the region; empty if nothing is.
std::string verify(const Region& region);
std::string print(const Region& region);

}  // namespace merker::icode
