#include "cpu/asynchronous_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/bytes.h"

namespace merker::cpu {
namespace {

struct ObRow {
  std::uint8_t ob;
  std::optional<Event> stop;
};
// S7-DIAG-03
constexpr ObRow kObs[] = {{80, Event::StopTimeError},           {81, std::nullopt},
                          {82, Event::StopDiagnosticInterrupt}, {83, Event::StopInsertRemove},
                          {84, Event::StopCpuHardware},         {85, Event::StopProgramSequence},
                          {86, Event::StopRackFailure},         {87, Event::StopCommunication}};

struct FaultRow {
  std::uint8_t fault;
  std::string_view text;
  enum class Detail : std::uint8_t {
    None,
    Address,  // logical address in bytes 6 and 7
    Racks,    // a bit for each rack in bytes 8 to 11
    Station   // DP station and its master system in bytes 11 and 10
  } detail = Detail::None;
};
using Detail = FaultRow::Detail;
// FLT_ID of OB 81 to 87 (S7-OBI-08 … -11 and the manual's chapters on these OBs).
constexpr FaultRow kFaults[] = {
    {0x21, "battery exhausted"},
    {0x22, "backup voltage missing"},
    {0x23, "24 V supply failed"},
    {0x31, "battery of an expansion rack exhausted"},
    {0x32, "backup voltage of an expansion rack missing"},
    {0x33, "24 V supply of an expansion rack failed"},
    {0x42, "module fault", Detail::Address},
    {0x61, "module removed", Detail::Address},
    {0x63, "module of a wrong type inserted", Detail::Address},
    {0x64, "module with a fault inserted", Detail::Address},
    {0x65, "module inserted, error in its parameters", Detail::Address},
    {0x81, "interface error"},
    {0x82, "memory error corrected by the operating system"},
    {0xA1, "OB not loaded"},
    {0xA2, "OB not loaded"},
    {0xA3, "error while the operating system accesses a block"},
    {0xB1, "I/O access error while updating the input image"},
    {0xB2, "I/O access error while writing the output image"},
    {0xB3, "I/O access error while updating the input image"},
    {0xB4, "I/O access error while writing the output image"},
    {0xC1, "rack failed", Detail::Racks},
    {0xC4, "DP station failed", Detail::Station},
    {0xD2, "diagnostic entries cannot be sent"},
    {0xE1, "wrong frame identification in global data communication"},
};

const FaultRow* faultRow(std::uint8_t fault) {
  const auto at = std::find_if(std::begin(kFaults), std::end(kFaults),
                               [&](const FaultRow& row) { return row.fault == fault; });
  return at == std::end(kFaults) ? nullptr : at;
}

constexpr std::uint8_t kGoing = 0x38, kComing = 0x39;  // event classes

std::string detailOf(const FaultRow& row, const StartInformation& start) {
  if (row.detail == Detail::Address) return fmt::format(": address {}", loadWord(&start[6]));
  if (row.detail == Detail::Station)
    return fmt::format(": station {} of DP master system {}", start[11], start[10]);
  std::string racks;
  const std::uint32_t bits = row.detail == Detail::Racks ? loadDWord(&start[8]) : 0;
  for (unsigned rack = 0; rack < 32; ++rack)
    if ((bits >> rack & 1) != 0)
      racks += fmt::format("{}{}", racks.empty() ? ": rack " : ", ", rack);
  return racks;
}

}  // namespace

std::optional<Event> stopWithout(std::uint8_t ob) {
  for (const ObRow& row : kObs)
    if (row.ob == ob) return row.stop;
  return std::nullopt;
}

bool comesFromModule(std::uint8_t ob) { return (ob >= 81 && ob <= 84) || ob == 86; }

bool namesModule(std::uint16_t event) {
  const FaultRow* row = faultRow(static_cast<std::uint8_t>(event));
  const auto eventClass = event >> 8;
  return (eventClass == kGoing || eventClass == kComing) && row != nullptr &&
         row->detail == Detail::Address;
}

std::string describe(const StartInformation& start) {
  if (start[3] == 80) return std::string(text(static_cast<Event>(loadWord(start.data()))));
  const FaultRow* row = faultRow(start[1]);
  std::string words(row == nullptr ? "asynchronous error" : row->text);
  if (start[0] == kGoing) words += ", going";
  if (start[0] == kComing) words += ", coming";
  return row == nullptr ? words : words + detailOf(*row, start);
}

}  // namespace merker::cpu
