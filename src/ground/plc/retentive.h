// What a PLC keeps without power (S7-MEM-02, S7-CPU-28, -32; S5-MEM-09), in the form in which a
// memory card holds it (docs/formats/card.md): plain values that it hands out at the end of a cycle
// and takes back when it is switched on. Times are nanoseconds of the virtual clock; `now` says
// what that clock showed, so that a reader knows how long each is ago or ahead.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "address/block_id.h"

namespace merker::block {

struct RetentiveTimer {
  std::uint8_t kind = 0;  // SI SV SE SS SA as 0..4
  bool startEdge = false, enableEdge = false, started = false, held = false;
  std::uint8_t base = 0;     // 0 = 10 ms … 3 = 10 s
  std::uint16_t frozen = 0;  // units left when a stop ended the run early
  std::int64_t end = 0;
  bool operator==(const RetentiveTimer&) const = default;
};

struct RetentiveCounter {
  std::uint16_t count = 0;
  bool setEdge = false, upEdge = false, downEdge = false, enableEdge = false;
  bool operator==(const RetentiveCounter&) const = default;
};

struct RetentiveDataBlock {
  std::uint16_t number = 0;
  bool madeByProgram = false;  // SFC 22: not in load memory
  std::vector<std::uint8_t> bytes;
  bool operator==(const RetentiveDataBlock&) const = default;
};

// An entry of the diagnostic buffer (S7-DIAG-01).
struct RetentiveEvent {
  std::uint16_t event = 0;
  std::int64_t time = 0;
  std::string text;
  bool placeKnown = false;
  BlockId block;
  std::uint32_t offset = 0;
  std::array<std::uint8_t, 10> info{};  // bytes 2..11
  std::array<std::uint8_t, 8> stamp{};  // DATE_AND_TIME
  bool operator==(const RetentiveEvent&) const = default;
};

// A run-time meter (S7-CPU-32): it counted this long until `since`, and goes on if it runs.
struct RetentiveMeter {
  std::int64_t counted = 0, since = 0;
  bool running = false;
  bool operator==(const RetentiveMeter&) const = default;
};

struct RetentiveData {
  std::int64_t now = 0;
  std::int64_t clock = 0;  // what the CPU's clock showed: milliseconds since 1990-01-01
  bool running = false;    // RUN or STARTUP, not STOP
  std::vector<RetentiveMeter> meters;
  std::vector<std::uint8_t> flags;
  std::vector<RetentiveTimer> timers;
  std::vector<RetentiveCounter> counters;
  std::vector<RetentiveDataBlock> dataBlocks;  // ascending numbers, those with NON_RETAIN left out
  std::uint64_t eventsAdded = 0;  // how many the buffer ever took: who has seen these knows them
  std::vector<RetentiveEvent> events;  // newest last
  bool operator==(const RetentiveData&) const = default;
};

}  // namespace merker::block
