// The receiving blocks (BRCV) of a program, as its partner meets them: segments become telegrams.
// A telegram is acknowledged when it is whole, whenever the program takes it; until then no other
// one comes for the same R_ID.
#pragma once

#include <map>

#include "s7comm/partner_job.h"
#include "s7comm/segment.h"

namespace merker::s7comm {

class BlockReceivers {
 public:
  static constexpr std::size_t kMost = 64;  // of a connection

  // As the program has it; an enabled one has taken what came before.
  void set(const Receiver& receiver);
  void clear() { receivers_.clear(); }
  // The connection has gone: what has begun never ends.
  void interrupt();

  struct Taken {
    SegmentAnswer answer{};
    std::size_t octets = 0;  // of its telegram, so far
    std::optional<Telegram> whole{};
  };
  Taken take(const Segment& segment);

 private:
  struct One {
    bool enabled = false, full = false;
    std::uint8_t sequence = 0;  // 0: no telegram has begun
    std::size_t total = 0, room = 0;
    Bytes octets{};
  };
  static void interruptOne(One& one);
  static bool isTooLong(const One& one, const Segment& segment);
  Error append(One& one, const Segment& segment);

  std::map<std::uint32_t, One> receivers_;  // by R_ID
  std::uint8_t sequence_ = 0;
};

}  // namespace merker::s7comm
