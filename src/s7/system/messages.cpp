// SFC 52 WR_USMSG (S7-SFC-20): an entry of the user in the diagnostic buffer.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "system/call.h"

namespace merker::system {
namespace {

struct Information {
  Sfc<52>::Name parameter;
  std::uint32_t bytes;
  std::array<TypeCode, 4> types;  // CHAR: as many as there are bytes
  std::uint32_t wrongType, wrongLength;
};

constexpr Information kFirst{
    "INFO1", 2, {TypeCode::Word, TypeCode::Int, TypeCode::Char, TypeCode::Word}, 0x8083, 0x8086};
constexpr Information kSecond{
    "INFO2", 4, {TypeCode::DWord, TypeCode::DInt, TypeCode::Real, TypeCode::Char}, 0x8084, 0x8087};

// Copies it; 0, or what is wrong with it.
std::uint32_t fetch(Sfc<52>& a, const Information& what, std::uint8_t* target) {
  const AnyPointer where = a.any(what.parameter);
  const bool time = what.bytes == 4 && where.type == TypeCode::Time;
  if (!time && std::find(what.types.begin(), what.types.end(), where.type) == what.types.end())
    return what.wrongType;
  if (byteCount(where) != what.bytes) return what.wrongLength;
  const Region region = a.region(where, what.bytes, cpu::Access::Read);
  if (!region) return what.wrongLength;
  std::copy_n(region.data, what.bytes, target);
  return 0;
}

}  // namespace

// Events 16#8xyz to 16#Bxyz belong to the user.
void writeUserMessage(Sfc<52>& a) {
  constexpr std::uint32_t kWrongEvent = 0x8085, kNobodyListens = 0x8091;
  const std::uint32_t event = a.value("EVENTN"), eventClass = event >> 12;
  if (eventClass < 8 || eventClass > 0xB) return a.status(kWrongEvent);
  std::array<std::uint8_t, 8> info{};  // bytes 4..11 of the entry
  if (const auto error = fetch(a, kFirst, &info[2])) return a.status(error);
  if (const auto error = fetch(a, kSecond, &info[4])) return a.status(error);
  a.cpu().log().note(static_cast<std::uint16_t>(event), fmt::format("user entry 16#{:04X}", event),
                     info);
  a.status(a.flag("SEND") && !a.alarms().areEventsHeard() ? kNobodyListens : 0);
}

}  // namespace merker::system
