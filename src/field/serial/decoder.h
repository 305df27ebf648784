// What the characters on a line mean: names of control characters, and for 3964(R) and RK 512 the
// block that they belong to (PTP-LINE-11).
#pragma once

#include <array>
#include <string>

#include "serial/parameters.h"
#include "serial/port.h"

namespace merker::serial {

// "STX", "41", "'A'"
std::string characterName(std::uint8_t value);

class Decoder {
 public:
  Decoder(Protocol protocol, bool blockCheck) : protocol_(protocol), blockCheck_(blockCheck) {}
  // The characters in the order of their ends. What this one is; empty: its name says it all.
  std::string meaning(const Sighting& sighting);

 private:
  enum class State : std::uint8_t { Idle, Called, Block, AfterDle, Check, Ended };
  std::string ofSender(std::uint8_t value);
  std::string ofOther(std::uint8_t value);
  std::string end();

  Protocol protocol_;
  bool blockCheck_;
  State state_ = State::Idle;
  std::size_t sender_ = 0;  // who called with STX
  std::uint8_t check_ = 0;
  std::vector<std::uint8_t> data_;
};

}  // namespace merker::serial
