// What is left of answers of several PDUs: the client asks for part after part, by the number of
// the answer.
#pragma once

#include <array>
#include <deque>

#include "s7comm/pdu.h"

namespace merker::s7comm {

struct Rest {
  std::uint8_t sequence = 0, unit = 0;
  Bytes octets{};
  std::size_t record = 1;           // is never cut
  std::deque<std::size_t> parts{};  // how long each is, unless that follows from the PDU
};

// Those of a connection.
class Rests {
 public:
  static constexpr std::size_t kMost = 8;  // as many as jobs; then the oldest is given up

  // Of the next answer: 1 to 255.
  std::uint8_t number();
  void keep(Rest rest);
  // Null: nothing is left of it.
  Rest* find(std::uint8_t sequence);
  void end(std::uint8_t sequence);
  // It was given up before the client had all of it.
  bool isLost(std::uint8_t sequence) const { return lost_[sequence]; }

 private:
  std::uint8_t last_ = 0;
  std::deque<Rest> rests_;
  std::array<bool, 256> lost_{};
};

}  // namespace merker::s7comm
