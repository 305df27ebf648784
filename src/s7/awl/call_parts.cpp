#include "awl/call_parts.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "mc7/operand_text.h"

namespace merker::awl {

namespace {

// The operand that a number of this type stands for. No source can name an SDB.
struct NumberWord {
  TypeCode type;
  std::string_view german, international;
};
constexpr NumberWord kNumberWords[] = {{TypeCode::Timer, "T", "T"},
                                       {TypeCode::Counter, "Z", "C"},
                                       {TypeCode::BlockFb, "FB", "FB"},
                                       {TypeCode::BlockFc, "FC", "FC"},
                                       {TypeCode::BlockDb, "DB", "DB"}};

}  // namespace

std::string numberText(TypeCode type, std::uint32_t number, Mnemonics mnemonics) {
  for (const NumberWord& row : kNumberWords)
    if (row.type == type)
      return fmt::format("{} {}", mnemonics == Mnemonics::German ? row.german : row.international,
                         number);
  return {};
}

std::string constantText(TypeCode type, std::uint32_t bits) {
  if (type == TypeCode::Real) return formatConstant({ConstantFormat::Real, bits});
  return formatValue(type, bits);
}

std::string pointerOf(std::uint32_t db, std::uint32_t pointer, Mnemonics mnemonics) {
  Area area = pointerArea(pointer);
  if (area == Area::CallerLocal) area = Area::Local;
  const std::string text = mc7::pointerText(area, pointerAddress(pointer), mnemonics);
  return db == 0 ? text : fmt::format("P#DB{}.{}", db, text.substr(2));
}

std::string anyText(std::uint32_t head, std::uint32_t count, std::uint32_t db,
                    std::uint32_t pointer, Mnemonics mnemonics) {
  const auto type = static_cast<TypeCode>(head & 0xFF);
  const std::string_view word = merker::name(type);
  if ((head >> 8) != 0x10 || word.empty()) return {};
  return fmt::format("{} {} {}", pointerOf(db, pointer, mnemonics), word, count);
}

}  // namespace merker::awl
