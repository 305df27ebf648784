// Synchronous errors: what one instruction can do wrong (S7-OBI-14, -15). The code is SW_FLT of OB
// 121 and OB 122.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "address/area.h"

namespace merker::cpu {

enum class ErrorCode : std::uint8_t {
  None = 0,
  Bcd = 0x21,
  LengthRead = 0x22,
  LengthWrite = 0x23,
  AreaRead = 0x24,
  AreaWrite = 0x25,
  TimerNumber = 0x26,
  CounterNumber = 0x27,
  AlignmentRead = 0x28,
  AlignmentWrite = 0x29,
  ProtectedDb = 0x30,
  ProtectedDi = 0x31,
  DbNumber = 0x32,
  DiNumber = 0x33,
  FcNumber = 0x34,
  FbNumber = 0x35,
  DbMissing = 0x3A,
  FcMissing = 0x3C,
  SfcMissing = 0x3D,
  FbMissing = 0x3E,
  SfbMissing = 0x3F,
  PeripheralRead = 0x42,
  PeripheralWrite = 0x43
};

struct SyncError {
  ErrorCode code = ErrorCode::None;
  Area area = Area::None;  // of the access
  Width width = Width::Bit;
  std::uint32_t detail = 0;  // byte address, timer, counter or block number

  explicit operator bool() const { return code != ErrorCode::None; }
  bool peripheral() const { return code >= ErrorCode::PeripheralRead; }
  // Diagnostic event: 16#25xx programming error, 16#29xx access error (S7-DIAG-02).
  std::uint16_t event() const {
    return static_cast<std::uint16_t>((peripheral() ? 0x2900 : 0x2500) |
                                      static_cast<unsigned>(code));
  }
  // RESERVED_1 of OB 121 and MEM_AREA of OB 122: bits 7..4 access, 3..0 area (S7-OBI-13).
  std::uint8_t accessByte() const {
    return static_cast<std::uint8_t>(static_cast<unsigned>(width) << 4 |
                                     (static_cast<unsigned>(area) & 7));
  }
};

std::string_view text(ErrorCode code);
// "area length error when reading: MW 300"
std::string describe(const SyncError& error);

}  // namespace merker::cpu
