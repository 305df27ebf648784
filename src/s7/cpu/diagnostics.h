// The diagnostic buffer: a ring of 100 events that survives memory reset (S7-DIAG-01, S7-STATE-10).
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "address/block_id.h"
#include "clock/instant.h"

namespace merker::cpu {

// Where in the program something happened.
struct Place {
  bool known = false;
  BlockId block{};
  std::uint32_t offset = 0;  // bytes of code
  bool replaced = false;     // the block has been loaded with other code since, or deleted
};

// Bytes 4..11 of an entry.
using DiagnosticInformation = std::array<std::uint8_t, 8>;
// As OB 121 has them: block type, 0, 0, 0, block number, byte in its code.
DiagnosticInformation informationOf(const Place& place);

struct DiagnosticEvent {
  std::uint16_t event = 0;
  Instant time{};
  std::string text{};
  Place place{};
  // Bytes 2..11 of the entry (S7-DIAG-01): priority class and OB that ran, then what belongs to the
  // event, as in start information.
  std::array<std::uint8_t, 10> info{};
  std::array<std::uint8_t, 8> stamp{};  // bytes 12..19: DATE_AND_TIME
};

class Diagnostics {
 public:
  static constexpr std::size_t kCapacity = 100;
  // The oldest entry makes room.
  void add(DiagnosticEvent event);
  void clear() { events_.clear(); }  // entries count on
  void replaced(const std::set<BlockId>& blocks);
  const std::vector<DiagnosticEvent>& events() const { return events_; }  // newest last
  std::uint64_t added() const { return added_; }

 private:
  std::vector<DiagnosticEvent> events_;
  std::uint64_t added_ = 0;
};

}  // namespace merker::cpu
