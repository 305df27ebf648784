// Where compiled code finds things in the state that it is given. Whoever owns the state says it;
// jit knows nothing else of a state. All places in bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "icode/region.h"

namespace merker::jit {

struct Layout {
  // Where the address of the first entry is, and the address behind the last one.
  struct List {
    int first = 0, end = 0;
    bool operator==(const List&) const = default;
  };
  // An open data block, or one that can be opened.
  struct Open {
    int begin = 0;  // of all of it
    int data = 0;   // address of its bytes
    int length = 0, writable = 0, number = 0;
    bool operator==(const Open&) const = default;
  };
  // Timers or counters.
  struct Cells {
    int first = 0;  // address of number 0
    int bytes = 0;  // from one to the next
    bool operator==(const Cells&) const = default;
  };

  int clock = 0, horizon = 0, instructions = 0;
  std::array<int, icode::kItems> items{};
  // Inputs, outputs, flags: where they begin behind the address at `image`, and how many bytes an
  // address that is computed may reach.
  int image = 0;
  std::array<std::uint32_t, 3> images{}, imageLengths{};
  Open data{}, instance{};

  Cells timers{}, counters{};
  std::array<int, icode::kFields> fields{};  // in a timer or counter
  int timerEnd = 0;                          // in a timer: the instant at which it ends

  // Blocks call each other in one of two ways. In frames of jit (blocks.h):
  struct Blocks {
    int top = 0;              // address of the Frame that runs
    int first = 0, last = 0;  // of the outermost, and of the innermost that there may be
    int sites = 0;            // address of the Sites, by number
    int dataBlocks = 0;       // address of OpenBlocks, by number
    bool operator==(const Blocks&) const = default;
  };
  std::optional<Blocks> blocks{};

  // In frames of the owner, one behind the other, with local data, parameters and what a caller
  // gets back:
  struct Code {
    int native = 0;  // address of NativeCode::entries; null: not compiled
    int mark = 0;    // icode::Inlined::mark; null: the block must be called
    int localBytes = 0;
    bool operator==(const Code&) const = default;
  };
  struct Frame {
    int bytes = 0;  // from one to the next
    int code = 0;   // address of the Code
    // The instruction to go on with; in the same 8 bytes `first`: nobody has called the block.
    int resume = 0, first = 0;
    int local = 0;                           // address of its local data
    int localLength = 0, localEnd = 0;       // bytes of these, and of all up to here
    int parameters = 0, parameterCount = 0;  // address of the list behind the call
    // Of the caller; `data` are both registers.
    int data = 0, ar2 = 0, relayActive = 0, relayDepth = 0, bracketDepth = 0;
    bool operator==(const Frame&) const = default;
  };
  // Data blocks by number.
  struct DataBlocks {
    List list{};
    int bytes = 0;              // from one to the next
    Open open{};                // in each: what a register gets; number 0: there is no such block
    std::uint32_t highest = 0;  // number
    bool operator==(const DataBlocks&) const = default;
  };
  struct Frames {
    int top = 0, end = 0;               // address of the frame that runs, and behind it
    int callLimit = 0;                  // address of the first frame that may not call
    int position = 0;                   // place of the instruction that called last
    int level = 0, levelBlocks = 0;     // an address, and from there the count of blocks
    int relayActive = 0, relayOff = 0;  // master control relay
    List relays{};                      // its zones, a byte each
    List brackets{};
    unsigned bracketBytes = 1;
    List functions{}, functionBlocks{};  // addresses of Code by number; null: there is none
    std::uint32_t localBytes = 0;        // the most for all blocks together
    // Local data of a block that nobody has called, from this byte to before that one, are not
    // accessed through pointers: the owner wants to see it.
    int watchedBegin = 0, watchedEnd = 0;
    Frame frame{};
    Code code{};
    DataBlocks dataBlocks{};
    bool operator==(const Frames&) const = default;
  };
  std::optional<Frames> frames{};
  // Then `instance` stands directly behind `data`, and each is as long as this.
  static constexpr int kOpenBytes = 24;

  int offsetOf(icode::Item item) const { return items[static_cast<std::size_t>(item)]; }
  bool operator==(const Layout&) const = default;
};

}  // namespace merker::jit
