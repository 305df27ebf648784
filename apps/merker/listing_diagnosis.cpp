#include "listing_diagnosis.h"

#include <fmt/format.h>

#include <iostream>

#include "scenario/duration.h"

namespace merker::app {
namespace {

// Their texts begin with their numbers, as on the screen of the control.
void printAlarms(const cnc::Cnc& control) {
  std::cout << "\nAlarms and messages\n";
  for (const sinumerik::PendingAlarm& alarm : control.plc().alarms())
    std::cout << fmt::format("  {:>12}  {}\n", simulator::formatTime(alarm.time), alarm.text);
}

struct Pseudo {
  std::uint16_t address;
  std::string_view meaning;
};
// Auskunft Adresse F000: fine error coding and the beginnings of the block lists (S5-ERR-11 … -15,
// S5-MEM-05).
constexpr Pseudo kPseudo[] = {{0xF000, "FEHLCODE"}, {0xF001, "alarm"},   {0xF002, "xxx1"},
                              {0xF003, "xxx2"},     {0xF004, "xxx3"},    {0xF005, "zob2"},
                              {0xF00C, "OB list"},  {0xF00D, "FB list"}, {0xF00E, "DB list"},
                              {0xF010, "SB list"},  {0xF011, "PB list"}};

std::uint16_t wordAt(cnc::Cnc& control, std::uint16_t address) {
  return control.plc().programmer().address(address).value_or(0);
}

void printFineCode(cnc::Cnc& control) {
  std::cout << "\nFine error coding (ADR WERT)\n";
  for (const Pseudo& row : kPseudo)
    std::cout << fmt::format("  {:04X} {:04X}  {}\n", row.address, wordAt(control, row.address),
                             row.meaning);
}

nlohmann::ordered_json fineCodeToJson(cnc::Cnc& control) {
  nlohmann::ordered_json rows;
  for (const Pseudo& row : kPseudo)
    rows[fmt::format("{:04X}", row.address)] = fmt::format("{:04X}", wordAt(control, row.address));
  return rows;
}

}  // namespace

// The control bits, the interrupt stack and the block stack as the programmer shows them after a
// STOP (S5-ERR-06 … -10).
void printScreens(cnc::Cnc& control) {
  printAlarms(control);
  printFineCode(control);
  const auto picture = control.plc().programmer().stopPicture();
  if (!picture) return;
  std::cout
      << "\nControl bits\n"
      << control.plc().programmer().controlBitText() << '\n'
      << "Interrupt stack (USTACK)\n"
      << toString(picture->interrupt)
      << "\nBlock stack (BSTACK), innermost first: where each block continues after the return\n"
      << toString(picture->blocks);
}

nlohmann::ordered_json screensToJson(cnc::Cnc& control) {
  nlohmann::ordered_json document;
  for (const sinumerik::PendingAlarm& alarm : control.plc().alarms())
    document["alarms"].push_back({{"number", alarm.number},
                                  {"seconds", static_cast<double>(alarm.time.ns) / 1e9},
                                  {"text", alarm.text}});
  document["fine_error_code"] = fineCodeToJson(control);
  const auto picture = control.plc().programmer().stopPicture();
  if (!picture) return document;
  document["control_bits"] = control.plc().programmer().controlBitText();
  document["interrupt_stack"] = toString(picture->interrupt);
  document["block_stack"] = toString(picture->blocks);
  return document;
}

}  // namespace merker::app
