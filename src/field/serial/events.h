// Errors and warnings of a serial interface, with the numbers that STATUS shows (PTP-SFBG-07, -08).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker::serial {

enum class Event : std::uint16_t {
  None = 0,
#define SERIAL_EVENT(number, name, text) name = number,
#include "serial/events.inc"
#undef SERIAL_EVENT
};

struct EventText {
  Event event;
  std::string_view text;
};
std::span<const EventText> events();

// Shown without ERROR (PTP-SFBG-09, PTP-ERR-64).
constexpr bool isWarning(Event event) {
  return event == Event::RepetitionSent || event == Event::RepetitionExpected ||
         event == Event::Empty || event == Event::NearlyFull;
}

}  // namespace merker::serial
