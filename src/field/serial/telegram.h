// Telegrams of the computer link RK 512 (technology manual 6.9.3; PTP-RK512-04 to -22).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "serial/events.h"
#include "serial/mailbox.h"

namespace merker::serial {

constexpr std::size_t kPart = 128;  // bytes of user data in a telegram

struct Flag {  // coordination flag
  std::uint8_t byte = 255, bit = 0;
  bool used() const { return byte != 255; }
};

// What a SEND or FETCH speaks of.
struct LinkJob {
  bool fetch = false;
  char type = 'D';  // D, X, M, E, A, Z, T
  std::uint8_t block = 0;
  std::uint16_t offset = 0;  // bytes; the number of a timer or counter
  std::uint16_t length = 0;  // bytes
  std::uint8_t cpu = 1;      // 0: none
  Flag flag{};

  bool inWords() const { return type == 'D' || type == 'X' || type == 'T' || type == 'Z'; }
  bool inBlock() const { return type == 'D' || type == 'X'; }
  // On the line: an odd number of bytes is filled up where words are counted.
  std::uint16_t transferred() const {
    return static_cast<std::uint16_t>(inWords() ? (length + 1U) / 2U * 2U : length);
  }
};

Bytes firstCommand(const LinkJob& job);
Bytes followOnCommand(const LinkJob& job);
Bytes reaction(bool followOn, std::uint8_t error);

// What a command is refused with: the number at STATUS and the one in the reaction telegram.
struct Denial {
  Event event = Event::None;
  std::uint8_t error = 0;
};

// A command of the partner: its job, or what is wrong with it and the number it is answered with.
struct Command {
  LinkJob job;
  bool followOn = false;
  Event event = Event::None;
  std::uint8_t error = 0;
  bool addressed = false;   // nothing is wrong up to byte 6: the area can be looked at first
  std::size_t header = 10;  // bytes in front of the data
};
bool isReaction(std::span<const std::uint8_t> telegram);
Command read(std::span<const std::uint8_t> telegram);

// The number of the event for an error number in a reaction telegram (PTP-RK512-47 to -57).
Event eventOfReaction(std::uint8_t error);

}  // namespace merker::serial
