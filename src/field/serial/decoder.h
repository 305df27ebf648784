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
// The same of all that a monitor sees: "BREAK"
std::string nameOf(const Sighting& sighting);
// What is wrong with it on the line, for a column of its own: "parity fault", "" if nothing
std::string faultsOf(const Sighting& sighting);

class Decoder {
 public:
  Decoder(Protocol protocol, bool blockCheck) : protocol_(protocol), blockCheck_(blockCheck) {}
  // The characters in the order of their ends. What this one is; empty: its name says it all.
  // What is wrong with it is said first.
  std::string meaning(const Sighting& sighting);

 private:
  enum class State : std::uint8_t { Idle, Called, Block, AfterDle, Check, Ended, Failed };
  std::string role(const Sighting& sighting);
  std::string inIdle(const Sighting& sighting);
  std::string open(const char* text);
  std::string ofSender(std::uint8_t value);
  std::string ofOther(std::uint8_t value);
  std::string end();

  Protocol protocol_;
  bool blockCheck_;
  State state_ = State::Idle;
  std::size_t sender_ = 0;  // who called with STX
  bool conflict_ = false;   // both did
  bool stray_ = false;      // characters that nobody expected
  bool faulty_ = false;     // a character of the block
  std::uint8_t check_ = 0;
  std::vector<std::uint8_t> data_;
};

}  // namespace merker::serial
