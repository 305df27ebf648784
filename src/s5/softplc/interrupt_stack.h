// What the programmer shows of a STOP: interrupt stack and block stack (S5-ERR-08, -10). SAZ,
// DB-ADR and BA-ADR are byte offsets in their segments, REL-SAZ counts words of the block as a
// listing does.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mc5/block_id.h"
#include "softplc/machine.h"
#include "softplc/trap.h"

namespace merker::sinumerik {

struct InterruptStack {
  unsigned depth = 1;                         // TIEFE: always the latest event
  std::uint16_t instruction = 0;              // BEF-REG: word two bytes before SAZ
  std::uint32_t stepAddress = 0;              // SAZ
  std::uint32_t dataAddress = 0;              // DB-ADR: DW 0 of the open data block
  std::uint32_t blockAddress = 0;             // BA-ADR: start of the running block (OP-19)
  unsigned blockStackPointer = 0;             // BST-STP
  std::optional<mc5::BlockId> block, caller;  // XX-NR, YY-NR
  std::optional<std::uint16_t> dataBlock;     // DB-NR
  std::uint32_t relativeStep = 0;             // REL-SAZ
  std::uint32_t dataLength = 0;               // DBL-REG, words
  std::uint16_t controlRegister = 0;          // UAMK
  std::uint32_t akku1 = 0, akku2 = 0;
  std::uint8_t displays = 0;  // ANZ1 ANZ0 OVFL OVFLS ODER STATUS VKE ERAB
  Causes causes;
};

// One entry of the block stack: a block that waits for the return of what it called.
struct BlockStackEntry {
  mc5::BlockId block;
  std::uint32_t returnAddress = 0, relative = 0;  // bytes in segment 5, words in the block
  std::optional<std::uint16_t> dataBlock;
};

struct StopPicture {
  InterruptStack interrupt;
  std::vector<BlockStackEntry> blocks;  // innermost first
};

// The machine as it stands, at the instruction that stopped it.
StopPicture takePicture(const Machine& machine, std::uint16_t controlRegister);
// With the cause; an overflow of the block stack shows the entry that found no room, too.
void addCause(StopPicture& picture, const Machine& machine, Alarm alarm);
// UAMK (S5-ERR-T4): bit 2 battery in order; nothing else happens in this PLC.
std::uint16_t controlRegister(bool batteryGood);

// The two screens "Unterbrechungsstack" and "BSTACK" as text.
std::string toString(const InterruptStack& stack);
std::string toString(const std::vector<BlockStackEntry>& stack);
using mc5::toString;  // of a block

}  // namespace merker::sinumerik
