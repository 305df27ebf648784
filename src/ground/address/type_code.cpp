#include "address/type_code.h"

#include <algorithm>
#include <array>

#include "base/text.h"

namespace merker {
namespace {

struct Row {
  TypeCode code;
  std::string_view keyword;
  unsigned bits;
};

// The first row of a type carries the keyword that is shown; later rows are further spellings.
constexpr std::array kTypes{
    Row{TypeCode::Void, "VOID", 0},
    Row{TypeCode::Bool, "BOOL", 1},
    Row{TypeCode::Byte, "BYTE", 8},
    Row{TypeCode::Char, "CHAR", 8},
    Row{TypeCode::Word, "WORD", 16},
    Row{TypeCode::Int, "INT", 16},
    Row{TypeCode::DWord, "DWORD", 32},
    Row{TypeCode::DInt, "DINT", 32},
    Row{TypeCode::Real, "REAL", 32},
    Row{TypeCode::Date, "DATE", 16},
    Row{TypeCode::TimeOfDay, "TIME_OF_DAY", 32},
    Row{TypeCode::Time, "TIME", 32},
    Row{TypeCode::S5Time, "S5TIME", 16},
    Row{TypeCode::DateAndTime, "DATE_AND_TIME", 64},
    Row{TypeCode::String, "STRING", 0},
    Row{TypeCode::Pointer, "POINTER", 0},
    Row{TypeCode::Any, "ANY", 0},
    Row{TypeCode::BlockFb, "BLOCK_FB", 0},
    Row{TypeCode::BlockFc, "BLOCK_FC", 0},
    Row{TypeCode::BlockDb, "BLOCK_DB", 0},
    Row{TypeCode::BlockSdb, "BLOCK_SDB", 0},
    Row{TypeCode::Counter, "COUNTER", 0},
    Row{TypeCode::Timer, "TIMER", 0},
    Row{TypeCode::TimeOfDay, "TOD", 32},
    Row{TypeCode::DateAndTime, "DT", 64},
};

// By code: a call of a system function asks for each of its parameters.
constexpr auto kBits = [] {
  std::array<std::uint8_t, 256> bits{};
  for (const Row& row : kTypes)
    bits[static_cast<std::uint8_t>(row.code)] = static_cast<std::uint8_t>(row.bits);
  return bits;
}();

const Row* find(TypeCode code) {
  const auto* const row =
      std::find_if(kTypes.begin(), kTypes.end(), [code](const Row& r) { return r.code == code; });
  return row == kTypes.end() ? nullptr : row;
}

}  // namespace

std::string_view name(TypeCode code) {
  const Row* const row = find(code);
  return row ? row->keyword : std::string_view();
}

std::optional<TypeCode> typeFromName(std::string_view keyword) {
  for (const Row& row : kTypes)
    if (equalsIgnoreCase(row.keyword, keyword)) return row.code;
  return std::nullopt;
}

unsigned bitWidth(TypeCode code) { return kBits[static_cast<std::uint8_t>(code)]; }

}  // namespace merker
