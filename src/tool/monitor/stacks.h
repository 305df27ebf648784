// B stack, I stack and L stack (S7-DIAG-04): the running blocks, what was interrupted, the local
// data. In STOP they show the moment at which the program was left; a restart clears them.
#pragma once

#include <vector>

#include "cpu/cpu.h"
#include "monitor/code_map.h"
#include "monitor/registers.h"

namespace merker::monitor {

// One running block. `place` is the instruction that stopped the program or comes next; in a block
// that waits for another one, the instruction it goes on with.
struct BlockStackEntry {
  SourcePlace place;
  std::uint16_t db = 0, di = 0;  // open data blocks, 0 = none
  bool organizationBlock = false;
};

// One priority class: where it stands, and its registers at that moment.
struct InterruptStackEntry {
  std::uint8_t ob = 0, priority = 0;
  bool errorOb = false;
  SourcePlace place;
  Registers registers;
  std::vector<Bracket> brackets;
  std::vector<bool> mcr;  // the master control relays, outermost first
};

struct LocalStackEntry {
  BlockId block{};
  std::vector<std::uint8_t> bytes;
};

struct Stacks {
  std::vector<BlockStackEntry> blocks;          // the running block first
  std::vector<InterruptStackEntry> interrupts;  // the running class first
  std::vector<LocalStackEntry> locals;          // as `blocks`
  bool empty() const { return blocks.empty(); }
  // STEP 5 knows one data block at a time.
  bool withoutDi() const { return !interrupts.empty() && !interrupts.front().registers.di; }
};

// What the block of a frame has open: index into machine.frames, the last one is the running block.
struct OpenBlocks {
  cpu::OpenBlock db, di;
  std::uint32_t ar2 = 0;
};
OpenBlocks openBlocks(const cpu::Machine& machine, std::size_t frame);

// In STOP and HALT; empty while the program runs, and when no block was running.
Stacks stacks(const cpu::Cpu& cpu, const block::Program& program);

}  // namespace merker::monitor
