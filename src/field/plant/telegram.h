// Standard telegrams of PROFIdrive: which words drive and master exchange. The words are those of
// the profile as SINAMICS lists them (basic positioner, function manual A5E34257659B, chapter 5).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker::plant {

struct TelegramWord {
  std::string_view signal;  // of the drive
  bool setpoint = false;    // from the master; else from the drive
  std::uint8_t word = 0;    // its first one, from 0
  std::uint8_t words = 1;   // 2: the high word first
};

struct Telegram {
  std::string_view name;                    // of the module in the slave
  std::uint8_t setpoints = 0, actuals = 0;  // words
  std::span<const TelegramWord> words;
};

// The signal of a drive that says whether its master is there; it is wired to the slave.
inline constexpr std::string_view kBusSignal = "BUS";

// Telegram 1: speed. Telegram 9: positions as manual data input (MDI).
extern const Telegram kTelegram1, kTelegram9;
std::span<const Telegram* const> telegrams();

}  // namespace merker::plant
