#include "serial/events.h"

namespace merker::serial {

std::span<const EventText> events() {
  static constexpr EventText kEvents[] = {
#define SERIAL_EVENT(number, name, text) {Event::name, text},
#include "serial/events.inc"
#undef SERIAL_EVENT
  };
  return kEvents;
}

}  // namespace merker::serial
