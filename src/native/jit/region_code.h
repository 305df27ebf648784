// Writes the machine code of one region: one function per operation of the intermediate code, named
// as the operation.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "address/area.h"
#include "jit/blocks.h"
#include "jit/native.h"
#include "jit/places.h"
#include "jit/ways.h"

namespace merker::jit {

// What the regions of a block share.
struct Unit {
  host::Assembler& code;
  const Layout& layout;
  const Options& options;
  const Instructions& answers;
  const Ways& ways;
  asmjit::Label epilogue;                    // with the instruction to go on with in eax
  asmjit::Label entrance = code.newLabel();  // emit_links.cpp
  std::vector<asmjit::Label> regions{};      // by instruction; not valid where none begins
};

void swapBlocks(const Unit& unit);  // rax, too
// How a call comes into a block (blocks.h): rax: its Site.
void writeEntrance(const Unit& unit);

class RegionCode {
 public:
  RegionCode(Unit& unit, const icode::Region& region);
  // The straight way; `next` is the region whose code will stand directly behind. False: the region
  // is too large for the stack frame.
  bool write(std::uint32_t next);
  // The ways that are rarely taken; after the straight ways of all regions.
  void writeWaysOut();

 private:
  struct StateSpot {
    Spot value;
    Spot a{}, b{};  // of a late operation
  };
  struct WayOut {
    asmjit::Label label;
    std::uint32_t exit;
    std::vector<StateSpot> states;
    std::vector<Spot> bytes;
    asmjit::Label zero{};   // where 0 in eax goes on after all (Ordinary)
    asmjit::Label front{};  // way out instead of it, if the block stack does not allow it
  };
  using Emit = void (RegionCode::*)(const icode::Op&);
  static Emit emitter(icode::Opcode code);
#define ICODE(id, text, result, arguments, effect) void id(const icode::Op& op);
#include "icode/icode.inc"
#undef ICODE

  void entry();
  void spoil(const Spot& spot, std::uint32_t bit);  // Options::broken
  void need(const host::Mem& limit, std::uint32_t bytes);
  host::Mem place(const icode::Op& op, unsigned bytes);
  void binary(const icode::Op& op, std::uint32_t instruction);
  void unary(const icode::Op& op, std::uint32_t instruction);
  void shift(const icode::Op& op, std::uint32_t instruction);
  void flag(asmjit::x86::CondCode condition);
  bool isForJump() const;
  bool isBehind(icode::Opcode code, const icode::Op& op) const;
  // No code is written for it.
  static bool isSilent(const icode::Op& op) {
    return !op.needed || op.late || op.code == icode::Opcode::Constant ||
           op.code == icode::Opcode::BitOf;
  }
  void compare(const icode::Op& op, asmjit::x86::CondCode condition);
  void overflows(const icode::Op& op, std::uint32_t instruction);
  void divide(const icode::Op& op);
  void real(const icode::Op& op, std::uint32_t instruction);
  // Where a bit stands.
  struct Bit {
    icode::Value root;  // in the register of this value
    unsigned position;
    bool isolated;  // all other bits of it are 0
  };
  Bit bit(icode::Value value) const;
  void turn(const host::Gp& to, const host::Gp& from, unsigned at, unsigned wanted);
  // `isOther`: the operation needs that register for something else, too.
  host::Gp moved(const Bit& bit, unsigned wanted, const host::Gp& scratch, bool isOther);
  host::Gp alone(icode::Value value, unsigned wanted, icode::Value other);
  void bits(const icode::Op& op, std::uint32_t instruction);
  void wayOut(const icode::Op& op, asmjit::x86::CondCode condition);
  // For guards with several conditions: where to jump if one does not hold. Registers and slots
  // stay as they are until the last of these jumps.
  asmjit::Label wayOut(const icode::Op& op);
  bool isInImage(const icode::Op& op, Area area) const;
  void locateByte(const icode::Op& op, const asmjit::Label& out);
  void locateAnywhere(bool write, const host::Gp& to, const asmjit::Label& out);
  void locateIn(Area area, bool write, const host::Gp& to, const asmjit::Label& out);
  void locateLocal(bool ofCaller, const host::Gp& to, const asmjit::Label& out);
  const Layout::Cells& cells(icode::Field field) const;
  int offsetOf(icode::Field field, const icode::Op& op) const;
  int timerEnd(const icode::Op& op) const;
  void runs(const icode::Op& op, const host::Mem& end);
  host::Mem field(const icode::Op& op, std::uint32_t bytes);
  void loadCell(const Layout::Cells& cells, icode::Value number);
  host::Mem fieldOf(const icode::Op& op, icode::Value number, std::uint32_t bytes);
  void shiftBy(const icode::Op& op, std::uint32_t instruction);
  void loadBlock(const icode::Op& op, const asmjit::Label& out);
  void writeState(const icode::Exit& exit, const std::vector<StateSpot>& states,
                  const std::vector<Spot>& bytes);
  void writeItem(const icode::StateWrite& write, const Spot& spot);
  void writeCompared(const icode::StateWrite& write, const Spot& a, const Spot& b,
                     asmjit::x86::CondCode condition);
  void writeCondition(const icode::StateWrite& write, asmjit::x86::CondCode condition);
  void writeWord(const icode::StateWrite& write, const Spot& spot);
  void writeLate(const icode::StateWrite& write, const StateSpot& spot);
  host::Gp fetch(const Spot& spot, const host::Gp& scratch);
  void writeByte(const icode::ByteWrite& write, const Spot& spot);
  void charge(const icode::Exit& exit);
  void goTo(std::uint32_t instruction, std::uint32_t next);
  void loadCode(const icode::Inlined& call);
  void pushFrame(const icode::Inlined& call);
  void goInside(const icode::Exit& exit);
  int frameOf(const icode::Inlined& call) const;
  asmjit::Label frontOf(const icode::Exit& exit);
  void checkStack(const icode::Exit& exit, const asmjit::Label& front);
  void goOn(const icode::Exit& exit, std::uint32_t next);
  void openLinked(const icode::Op& op);
  bool isRead(const icode::Exit& exit, icode::Value value) const;
  std::vector<StateSpot> spotsOfStates(const icode::Exit& exit) const;
  std::vector<Spot> spotsOfBytes(const icode::Exit& exit) const;
  void noteIsolated(icode::Value value);
  int offsetOf(icode::Item item) const { return unit_.layout.offsetOf(item); }
  const Layout::Frames& frames() const { return *unit_.layout.frames; }
  const Layout::Open& openBlock(icode::Space space) const {
    return space == icode::Space::Instance ? unit_.layout.instance : unit_.layout.data;
  }
  const Layout::Open& otherThan(icode::Space space) const {
    return space == icode::Space::Instance ? unit_.layout.data : unit_.layout.instance;
  }

  Unit& unit_;
  host::Assembler& code_;
  const icode::Region& region_;
  Places places_;
  std::vector<bool> isolated_;
  std::vector<std::uint8_t> position_;  // of a bit in its register
  std::vector<WayOut> waysOut_;
  asmjit::Label tooNear_;
  asmjit::Label zero_{};                          // of the way out that is written next
  std::optional<asmjit::x86::CondCode> fused_{};  // the bit that comes next stands in the flags
  icode::Value current_ = 0;
  std::uint32_t next_ = 0;
};

}  // namespace merker::jit
