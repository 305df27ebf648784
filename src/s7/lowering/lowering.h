// Machine instructions to intermediate code: one function per instruction, by table.
#pragma once

#include <map>
#include <optional>
#include <span>

#include "catalogue/cpu_model.h"
#include "icode/builder.h"
#include "mc7/listing.h"

namespace merker::translate {

// An operand in memory as the byte where it begins; of a bit: the byte around it.
struct BitPlace {
  icode::Space space = icode::Space::Input;
  std::uint32_t place = 0;                 // direct …
  icode::Value offset = icode::kNoValue;   // … behind so many bytes
  icode::Value address = icode::kNoValue;  // anywhere
  icode::Value bit = icode::kNoValue;
  std::uint32_t direct = 0;  // bit
};
// So many bytes behind this byte lie below the limit.
struct Reach {
  icode::Value byte, limit;
  std::uint32_t end;
};

// A called block whose instructions stand in the region of its caller.
struct Inside {
  // Where its local data and those of its caller begin, in bytes behind those of the region's
  // block, and how many there are.
  std::uint32_t local, localBytes, callerLocal, callerLocalBytes;
  bool callerIsOb;  // of the region: the owner wants to see some of its local data
  std::span<const std::uint32_t> list;  // behind the call
};

// The instruction that is being translated, and what a function may use for it.
struct Lowering {
  icode::Builder& to;
  icode::Needs& needs;
  const CpuModel& model;
  const mc7::Listing& listing;
  std::uint32_t place;
  std::vector<std::array<icode::Value, 3>>& brackets;  // RLO, OR, /ER in front of each
  std::vector<Reach>& reached;                         // in this region
  std::map<std::uint32_t, BitPlace>& ahead;  // operands in brackets, guarded in front of them
  const Inside* inside = nullptr;            // null: it is one of the region's block
  bool follows = false;    // a jump here leads back, and the region may go on there
  std::uint32_t next = 0;  // where it goes on
  bool ended = false;      // the way on leads elsewhere: nothing may follow in this region

  // In place of the one that stands there: its operand is known from the call.
  const mc7::Instruction* known = nullptr;

  const mc7::Instruction& instruction() const {
    return known != nullptr ? *known : listing.places[place].instruction;
  }
  const mc7::Operand& operand() const { return instruction().operand; }
  // A byte of the running block, as the region knows it.
  std::uint32_t at(icode::Space space, std::uint32_t byte) const {
    return inside != nullptr && space == icode::Space::Local ? inside->local + byte : byte;
  }
};

// False: not translated; the builder has not been touched.
using Lower = bool (*)(Lowering&);
struct Row {
  mc7::Operation operation;
  Lower lower;
};

std::span<const Row> bitRows();
std::span<const Row> moveRows();
std::span<const Row> numberRows();
std::span<const Row> shiftRows();
std::span<const Row> realRows();
std::span<const Row> jumpRows();
std::span<const Row> callRows();
std::span<const Row> timerRows();
std::span<const Row> bcdRows();

// The timer or counter of the operand, which the CPU has. Nothing: it is another operand, or this
// number is not translated.
std::optional<icode::Cell> timerOf(Lowering& l);
std::optional<icode::Cell> counterOf(Lowering& l);
bool isTimer(mc7::OperandKind kind);
bool isCounter(mc7::OperandKind kind);
// Instructions of timers and counters that share their mnemonic with others.
bool loadTimerOrCounter(Lowering& l);
icode::Value timerStatus(Lowering& l, const icode::Cell& timer);
icode::Value counterStatus(Lowering& l, const icode::Cell& counter);
bool resetTimerOrCounter(Lowering& l);
bool setCounter(Lowering& l);

// Binary coded decimal.
icode::Value toBcd(Lowering& l, icode::Value number, unsigned digits);
icode::Value fromBcd(Lowering& l, icode::Value bcd, unsigned digits);
icode::Value isBcd(Lowering& l, icode::Value bcd);  // bit; at most 7 digits, 0 above them

// Operands. Nothing: this operand is not translated.
std::optional<icode::Value> readBit(Lowering& l);
std::optional<icode::Value> readOperand(Lowering& l, Width width);
bool writeOperand(Lowering& l, Width width, icode::Value value);
// Every other way to an operand than a direct one (indirect.cpp).
std::optional<BitPlace> indirectPlace(Lowering& l, const icode::Access& access);
// Nothing: the list behind the call has no such entry.
std::optional<icode::Value> parameterPointer(Lowering& l);
std::optional<icode::Space> spaceOf(Area area);
std::uint32_t imageLength(const CpuModel& model, icode::Space space);
// How many bytes of the space the next instructions reach directly, and whether they write.
struct Wanted {
  std::uint32_t end = 0;
  bool write = false;
};
Wanted lookout(const Lowering& l, icode::Space space);
// Bytes of the space that may be read, or written.
icode::Value limitOf(Lowering& l, icode::Space space, bool write);
// Whether a guard in this region, or AUF, has seen to it that so many bytes behind this one are
// there; kNoValue: from the beginning of the space.
bool isReached(Lowering& l, icode::Space space, icode::Value byte, std::uint32_t end, bool write);
// Notes what the region needs, or guards; false if the operand is known to be out of range.
bool reachable(Lowering& l, icode::Space space, std::uint32_t end, bool write);
// Timer, counter or block: in a word of memory, or handed over as parameter.
std::optional<icode::Value> numberOperand(Lowering& l);
std::optional<BitPlace> bitPlace(Lowering& l, bool write);
icode::Value loadBytes(Lowering& l, const BitPlace& place, unsigned bytes);
void storeBytes(Lowering& l, const BitPlace& place, unsigned bytes, icode::Value value);
inline icode::Value loadByte(Lowering& l, const BitPlace& place) { return loadBytes(l, place, 1); }
inline void storeByte(Lowering& l, const BitPlace& place, icode::Value byte) {
  storeBytes(l, place, 1, byte);
}
// The byte with the bit as told.
icode::Value withBit(Lowering& l, const BitPlace& place, icode::Value byte, icode::Value bit);
icode::Value bitIn(Lowering& l, const BitPlace& place, icode::Value byte);

inline bool isOpening(mc7::Operation o) {
  return o >= mc7::Operation::AND_OPEN && o <= mc7::Operation::XOR_NOT_OPEN;
}
// Whether U( at this place has its ) in the same region. Whatever between them can fail is guarded
// now: inside brackets there is no way out.
bool prepareBracket(Lowering& l, std::span<const std::uint8_t> isEntry);

}  // namespace merker::translate
