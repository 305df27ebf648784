#include "listing_diagnosis.h"

#include <fmt/format.h>

#include <iostream>

#include "scenario/duration.h"
#include "scenario/state_text.h"

namespace merker::app {
namespace {

std::string state(const cnc::Cnc& control) {
  std::string text = fmt::format("{}: {} after {}, {} cycles", control.modelName(),
                                 simulator::modeName(control.mode()),
                                 simulator::formatTime(control.now()), control.cycles());
  if (control.mode() == controller::Mode::Stop) text += "\nSTOP: " + control.stopReason();
  return text;
}

// Their texts begin with their numbers, as on the screen of the control.
void printAlarms(const cnc::Cnc& control) {
  std::cout << "\nAlarms and messages\n";
  for (const sinumerik::PendingAlarm& alarm : control.plc().alarms())
    std::cout << fmt::format("  {:>12}  {}\n", simulator::formatTime(alarm.time), alarm.text);
}

void printHistory(const cnc::Cnc& control) {
  std::cout << "\nHistory, newest first\n";
  const auto& list = control.diagnostics();
  for (auto entry = list.rbegin(); entry != list.rend(); ++entry)
    std::cout << fmt::format("  {:>12}  {}\n", simulator::formatTime(entry->time), entry->text);
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
void printDiagnosis(cnc::Cnc& control) {
  std::cout << state(control) << '\n';
  printAlarms(control);
  printHistory(control);
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

nlohmann::ordered_json diagnosisToJson(cnc::Cnc& control) {
  nlohmann::ordered_json document = {{"model", control.modelName()},
                                     {"mode", simulator::modeName(control.mode())},
                                     {"seconds", static_cast<double>(control.now().ns) / 1e9},
                                     {"cycles", control.cycles()},
                                     {"stop_reason", control.stopReason()}};
  for (const sinumerik::PendingAlarm& alarm : control.plc().alarms())
    document["alarms"].push_back({{"number", alarm.number},
                                  {"seconds", static_cast<double>(alarm.time.ns) / 1e9},
                                  {"text", alarm.text}});
  for (const controller::DiagnosticEntry& entry : control.diagnostics())
    document["diagnostics"].push_back({{"event", entry.event},
                                       {"seconds", static_cast<double>(entry.time.ns) / 1e9},
                                       {"text", entry.text}});
  document["fine_error_code"] = fineCodeToJson(control);
  const auto picture = control.plc().programmer().stopPicture();
  if (!picture) return document;
  document["control_bits"] = control.plc().programmer().controlBitText();
  document["interrupt_stack"] = toString(picture->interrupt);
  document["block_stack"] = toString(picture->blocks);
  return document;
}

}  // namespace merker::app
