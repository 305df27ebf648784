#include "awl/call_parts.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "mc7/operand_text.h"

namespace merker::awl {

namespace {

// The operand that a number of this type stands for. No source can name an SDB.
struct NumberWord {
  TypeCode type;
  std::string_view word;
};
constexpr NumberWord kNumberWords[] = {{TypeCode::Timer, "T"},
                                       {TypeCode::Counter, "Z"},
                                       {TypeCode::BlockFb, "FB"},
                                       {TypeCode::BlockFc, "FC"},
                                       {TypeCode::BlockDb, "DB"}};

}  // namespace

std::string numberText(TypeCode type, std::uint32_t number) {
  for (const NumberWord& row : kNumberWords)
    if (row.type == type) return fmt::format("{} {}", row.word, number);
  return {};
}

std::string constantText(TypeCode type, std::uint32_t bits) {
  if (type == TypeCode::Real) return formatConstant({ConstantFormat::Real, bits});
  return formatValue(type, bits);
}

std::string pointerOf(std::uint32_t db, std::uint32_t pointer) {
  Area area = pointerArea(pointer);
  if (area == Area::CallerLocal) area = Area::Local;
  const std::string text = mc7::pointerText(area, pointerAddress(pointer), Mnemonics::German);
  return db == 0 ? text : fmt::format("P#DB{}.{}", db, text.substr(2));
}

std::string anyText(std::uint32_t head, std::uint32_t count, std::uint32_t db,
                    std::uint32_t pointer) {
  const auto type = static_cast<TypeCode>(head & 0xFF);
  const std::string_view word = merker::name(type);
  if ((head >> 8) != 0x10 || word.empty()) return {};
  return fmt::format("{} {} {}", pointerOf(db, pointer), word, count);
}

}  // namespace merker::awl
