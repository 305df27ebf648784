// Executes MC5 on a machine, instruction by instruction, and charges its time. Knows no operating
// system: who starts levels, counts timers and answers traps stands above.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mc5/instruction.h"
#include "softplc/machine.h"
#include "softplc/trap.h"

namespace merker::sinumerik {

class Processor;

// Resident function macros (S5-FM): blocks of the basic program that are no MC5.
class Macros {
 public:
  virtual ~Macros() = default;
  virtual bool has(std::uint16_t number) const = 0;
  // `parameters`: the words of the call's parameter list. The trap if the macro stops the PLC.
  virtual std::optional<Trap> call(std::uint16_t number, Machine& machine,
                                   std::span<const std::uint16_t> parameters) = 0;

  // What the operating system tells them: the start-up (no jobs, empty flag stack), the STOP, and
  // the beginning of each cycle, before OB 1.
  virtual void restart(Machine& /*machine*/) {}
  virtual void stops() {}
  virtual void cycleBegins() {}
  // Jobs go on beside the program: does all that is due up to `now`. The trap if one stops the PLC.
  virtual std::optional<Trap> advance(Machine& /*machine*/, Instant /*now*/) {
    return std::nullopt;
  }
  virtual Instant next() const { return Instant::never(); }  // when advance has something to do
  virtual void delay(Duration /*by*/) {}                     // the PLC was in HALT for so long
  virtual bool masterPlcRuns() const { return true; }        // else alarm 6163 (S5-FM-54)
};

// What machine data decide.
struct Environment {
  mc5::Variant variant = mc5::Variant::Acop;
  bool systemCommands = false;  // MD 2003: LIR TIR TNB TNW allowed (OP-09)
  unsigned lastTimer = 15;      // MD 6
  TimeBases timeBases{Duration::milliseconds(10), Duration::milliseconds(100), Duration::seconds(1),
                      Duration::seconds(10)};
  Macros* macros = nullptr;
};

enum class Outcome : std::uint8_t {
  Next,        // goes on
  LevelEnded,  // the OB has ended
  Trapped      // trap() says why; the machine stands at the instruction
};

// The handler of an operation. False: nothing was done (condition not met, no edge), which takes
// the shorter of the two printed times (S5-OPC-04).
using Handler = bool (*)(Processor& processor, const mc5::Instruction& instruction);

class Processor {
 public:
  Processor(Machine& machine, const Environment& environment);

  // Puts the OB on a new level. False: it is not loaded.
  bool begin(std::uint8_t ob);
  // One instruction; B and what it processes count as one (S5-PROC-09).
  Outcome step();

  const Trap& trap() const { return run_.trap; }
  bool stpSeen() const { return stp_; }  // STP: the cycle is finished first (OP-38)
  void clearStp() { stp_ = false; }
  std::uint64_t instructions() const { return instructions_; }
  void count(std::uint64_t instructions) { instructions_ += instructions; }  // done elsewhere
  // How many levels began and macros were called.
  std::uint64_t levels() const { return levels_; }
  std::uint64_t macroCalls() const { return macroCalls_; }
  // So many cycles of one level have passed, like the last one.
  void pass(std::uint64_t cycles, std::uint64_t instructionsEach) {
    instructions_ += cycles * instructionsEach;
    levels_ += cycles;
  }
  // Word of the instruction that ran last; behind B the one that was processed.
  std::uint32_t lastWord() const { return run_.current; }
  const Level& endedLevel() const { return ended_; }  // after LevelEnded: as its BE left it
  // What the registers would be after this code (loads and queries only); the machine, its time
  // and the running instruction stay as they are. Nothing if a trap came.
  std::optional<Registers> probe(std::span<const std::uint16_t> code, bool firstScan);

  // for handlers
  Machine& machine() { return machine_; }
  const Machine& machine() const { return machine_; }
  const Environment& environment() const { return environment_; }
  Registers& registers() { return machine_.registers(); }
  Displays& displays() { return machine_.displays(); }
  bool vke() { return machine_.displays().vke; }
  bool fail(Alarm alarm, std::uint16_t word1 = 0, std::uint16_t word2 = 0, std::uint16_t word3 = 0);
  std::uint16_t opcode() const { return run_.opcode; }  // first word of the running instruction
  void jump(std::int32_t words);                        // from the running instruction
  bool call(mc5::BlockId block);
  void leave();
  void requestStop() { stp_ = true; }
  // Executes another instruction in place of the running one: B DW, B MW, formal operands.
  bool substitute(const mc5::Instruction& instruction);
  // The instruction behind B and its first word; nothing if it is none.
  std::optional<mc5::Decoded> fetchNext();
  // Word `index` (1 = first) of the parameter list of the running block's call.
  std::optional<std::uint16_t> parameter(std::uint32_t index) const;

 private:
  struct Cached {
    mc5::Instruction instruction;
    const mc5::Encoding* encoding = nullptr;  // null: not decoded yet
    std::uint16_t first = 0, second = 0, third = 0;
    std::uint8_t words = 0;
  };

  // The running instruction.
  struct Running {
    Trap trap;
    bool trapped = false, levelEnded = false;
    std::uint16_t opcode = 0, substituted = 0;
    std::uint32_t current = 0;  // its word
    unsigned depth = 0;         // of substitutions
  };

  std::optional<mc5::Decoded> fetch(std::uint32_t word);
  bool execute(const mc5::Decoded& decoded);
  bool refuse(const mc5::Instruction& instruction);
  bool foreignCell(const mc5::Decoded& decoded);
  void charge(const mc5::Encoding& encoding, bool done);
  bool callMacro(std::uint16_t number);
  bool executeAll(std::span<const std::uint16_t> code);

  Machine& machine_;
  const Environment& environment_;
  std::vector<Cached> cache_;  // by word of segment 5
  Running run_;
  Level ended_;
  bool stp_ = false;
  std::uint64_t instructions_ = 0, levels_ = 0, macroCalls_ = 0;
};

}  // namespace merker::sinumerik
