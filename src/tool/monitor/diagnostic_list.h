// The diagnostic buffer as a person reads it (S7-DIAG-01): newest first, with what it means and
// which line "open block" opens.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/code_map.h"
#include "station/station.h"

namespace merker::monitor {

struct DiagnosticLine {
  unsigned number = 1;  // 1 = newest
  Instant time;
  // ms since 1990-01-01, as the clock of the machine showed it then; nothing: it has none
  std::optional<std::int64_t> clock;
  std::uint16_t event = 0;
  std::string eventText;  // "16#2521", "6149": as the machine shows it
  std::string text;
  std::string help;  // what the event means and what to do; empty if nothing needs doing
  std::optional<SourcePlace> place;
  // Of a module, or of a part of the periphery that did not answer.
  struct ModuleAddress {
    std::uint16_t address = 0;
    bool output = false;
  };
  std::optional<ModuleAddress> module{};
};

std::vector<DiagnosticLine> diagnosticList(const station::Station& station);

// Cause and remedy of an event number; empty for events that are no faults.
std::string_view diagnosticHelp(std::uint16_t event);

}  // namespace merker::monitor
