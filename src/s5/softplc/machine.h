// Everything a STEP 5 program sees and changes. Plain values; the interpreter works on this and on
// nothing else.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "clock/instant.h"
#include "softplc/block_memory.h"
#include "softplc/counter.h"
#include "softplc/registers.h"
#include "softplc/timer.h"

namespace merker::sinumerik {

constexpr std::size_t kImageBytes = 128, kFlagBytes = 256, kCells = 32;
constexpr std::size_t kNesting = 12;        // blocks, the OB among them (S5-BLK-07)
constexpr std::size_t kInterruptDepth = 2;  // levels (S5-ERR-09)

// Input and output modules by byte address; a byte without module does not answer (6154).
struct Periphery {
  std::array<std::uint8_t, kImageBytes> inputs{}, outputs{};
  std::array<bool, kImageBytes> inputPresent{}, outputPresent{};
};

// The open data block: number and place of its words in segment 6.
struct OpenData {
  bool open = false;
  std::uint16_t number = 0;
  std::uint32_t start = 0, length = 0;  // words
};

// A block that runs or waits for the return of what it called.
struct Frame {
  mc5::BlockId block;
  std::uint32_t start = 0;       // word of segment 5 where its code begins
  std::uint32_t next = 0;        // word of the next instruction
  std::uint32_t parameters = 0;  // word of the parameter list of its call; 0 = none
  OpenData data;
};

// One processing level: start-up and cycle, or the alarm level that interrupts it.
struct Level {
  std::uint8_t ob = 1;
  std::vector<Frame> frames;  // block stack, innermost last
  Registers registers;
};

// What the block lists say of the segments (S5-MEM-06): their addresses, and whether offsets of
// code count bytes (ACOP) or words (COP); those of data always count bytes.
struct Layout {
  std::uint16_t program = 0x1400, data = 0x1280;
  bool byteOffsets = true;
};

struct Machine {
  Machine(std::uint32_t programWords, std::uint32_t dataWords) : blocks(programWords, dataWords) {}

  Instant clock;
  std::bitset<256> dataInEprom;  // data blocks that nobody can write, by number
  std::vector<Level> levels;     // at most two (S5-ERR-09); the last one runs
  BlockMemory blocks;
  std::array<std::uint8_t, kImageBytes> inputs{}, outputs{};
  std::array<std::uint8_t, kFlagBytes> flags{};
  std::array<Timer, kCells> timers;
  std::array<Counter, kCells> counters;
  Periphery periphery;
  Layout layout;

  Level& level() { return levels.back(); }
  Frame& frame() { return levels.back().frames.back(); }
  Registers& registers() { return levels.back().registers; }
  Displays& displays() { return levels.back().registers.displays; }
};

}  // namespace merker::sinumerik
