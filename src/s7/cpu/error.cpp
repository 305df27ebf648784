#include "cpu/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::cpu {
namespace {

struct Row {
  ErrorCode code;
  std::string_view text;
  std::string_view detail;  // what `detail` counts; "memory" for an address
};

constexpr Row kRows[] = {
    {ErrorCode::Bcd, "BCD conversion error", ""},
    {ErrorCode::LengthRead, "area length error when reading", "memory"},
    {ErrorCode::LengthWrite, "area length error when writing", "memory"},
    {ErrorCode::AreaRead, "area error when reading", ""},
    {ErrorCode::AreaWrite, "area error when writing", ""},
    {ErrorCode::TimerNumber, "timer number error", "T"},
    {ErrorCode::CounterNumber, "counter number error", "Z"},
    {ErrorCode::AlignmentRead, "alignment error when reading", "memory"},
    {ErrorCode::AlignmentWrite, "alignment error when writing", "memory"},
    {ErrorCode::ProtectedDb, "write access to a write-protected data block", "memory"},
    {ErrorCode::ProtectedDi, "write access to a write-protected instance data block", "memory"},
    {ErrorCode::DbNumber, "data block number error", "DB"},
    {ErrorCode::DiNumber, "instance data block number error", "DB"},
    {ErrorCode::FcNumber, "FC number error", "FC"},
    {ErrorCode::FbNumber, "FB number error", "FB"},
    {ErrorCode::DbMissing, "data block not loaded", "DB"},
    {ErrorCode::FcMissing, "FC not loaded", "FC"},
    {ErrorCode::SfcMissing, "SFC not present", "SFC"},
    {ErrorCode::FbMissing, "FB not loaded", "FB"},
    {ErrorCode::SfbMissing, "SFB not present", "SFB"},
    {ErrorCode::PeripheralRead, "I/O access error when reading", "memory"},
    {ErrorCode::PeripheralWrite, "I/O access error when writing", "memory"},
};

std::string memoryName(const SyncError& error) {
  constexpr std::string_view kAreas[] = {"P", "E", "A", "M", "DB", "DI", "L", "V"};
  constexpr std::string_view kWidths[] = {"X", "B", "W", "D"};
  if (error.peripheral())
    return fmt::format("P{}{} {}", error.code == ErrorCode::PeripheralRead ? "E" : "A",
                       kWidths[std::max(1u, static_cast<unsigned>(error.width))], error.detail);
  return fmt::format("{}{} {}", kAreas[static_cast<unsigned>(error.area) & 7],
                     kWidths[static_cast<unsigned>(error.width)], error.detail);
}

}  // namespace

std::string_view text(ErrorCode code) {
  for (const Row& row : kRows)
    if (row.code == code) return row.text;
  return "unknown error";
}

std::string describe(const SyncError& error) {
  for (const Row& row : kRows) {
    if (row.code != error.code) continue;
    if (row.detail.empty()) return std::string(row.text);
    if (row.detail == "memory") return fmt::format("{}: {}", row.text, memoryName(error));
    return fmt::format("{}: {} {}", row.text, row.detail, error.detail);
  }
  return "unknown error";
}

}  // namespace merker::cpu
