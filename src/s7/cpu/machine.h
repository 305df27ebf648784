// Everything a running program sees and changes. Plain values; engines work on this and on nothing
// else.
#pragma once

#include <cstdint>
#include <vector>

#include "clock/instant.h"
#include "cpu/areas.h"
#include "cpu/data_blocks.h"
#include "cpu/frame.h"
#include "cpu/outlook.h"
#include "cpu/registers.h"
#include "cpu/s5_counter.h"
#include "cpu/s5_timer.h"

namespace merker::cpu {

class Cpu;

struct Machine {
  explicit Machine(const CpuModel& model);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  // what every instruction touches
  Instant clock;
  Instant horizon;  // an engine returns at the first instruction boundary at or after it
  Registers registers;
  std::uint8_t* image = nullptr;  // areas.image
  Frame* top = nullptr;           // never null: below the first block lies an empty frame
  bool mcrOff = false;            // MCR active and its relay 0: = and T write 0, S and R do nothing
  bool fourAccumulators = false;
  bool probing = false;  // a check looks at operands: errors are noted, nothing happens
  bool probeFailed = false;
  bool levelEnded = false;  // BE of an OB was reached
  std::uint64_t instructions = 0;
  std::uint32_t position = 0;  // offset of the instruction that calls or fails, for messages

  // master control relay (S7-INSTR-129) and brackets (S7-INSTR-08)
  bool mcrActive = false;
  std::vector<std::uint8_t> mcrStack;
  std::vector<Bracket> brackets;
  // The innermost zone of this level counts; without any zone the relay is on.
  void updateMcr() {
    const std::size_t base = levels.empty() ? 0 : levels.back().mcrBase;
    mcrOff = mcrActive && mcrStack.size() > base && mcrStack.back() == 0;
  }

  std::vector<Frame> frames;
  // A block in a frame below this one may call another: neither the nesting depth nor the memory of
  // `frames` ends there. Null while a synchronous error OB runs, which has a depth of its own.
  const Frame* callLimit = nullptr;
  std::vector<Level> levels;
  std::vector<std::vector<std::uint8_t>> localStacks;

  Areas areas;
  DataBlocks dataBlocks;
  std::vector<S5Timer> timers;
  std::vector<S5Counter> counters;

  // What this cycle has looked at besides memory; of each timer, whether a program can load its
  // time; how many OBs have begun.
  Outlook outlook;
  std::vector<std::uint8_t> loadedTimers;
  std::uint64_t levelsStarted = 0;

  // Loaded code by block number; null = not loaded.
  std::vector<const Code*> functions, functionBlocks, organizationBlocks;

  const CpuModel* model;
  Cpu* cpu = nullptr;  // the operating system: faults, system functions

  // Puts a block on the stack. False: nesting depth or local data exhausted, the CPU has gone to
  // STOP.
  bool enter(const Code* code);
  void updateCallLimit();  // after a change of levels
  // Takes the top block off and gives the caller its registers back.
  void leave();
  void interrupt() {
    horizon = Instant{INT64_MIN};
  }  // lets the engine return after this instruction
  // Local data of the block that called the running one; null if none.
  const Frame* caller() const;
  // After creation or deletion of a data block: registers and saved registers see the new place.
  void reopenBlocks();
};

inline const Code* find(const std::vector<const Code*>& table, std::uint32_t number) {
  return number < table.size() ? table[number] : nullptr;
}

}  // namespace merker::cpu
