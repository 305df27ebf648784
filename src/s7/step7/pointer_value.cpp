#include "step7/pointer_value.h"

#include <algorithm>

#include "address/constant.h"
#include "base/text.h"
#include "step7/declaration.h"

namespace merker::step7 {
namespace {

// "DB10." or "DB 10." before the area. Nothing, and the cursor as it was, if there is none.
std::optional<std::uint16_t> dataBlock(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  cursor.skipBlanks();
  const std::string_view word = cursor.word();
  if (word.size() >= 2 && equalsIgnoreCase(word.substr(0, 2), "DB") &&
      word.find_first_not_of("0123456789", 2) == std::string_view::npos) {
    cursor.seek(cursor.pos() - (word.size() - 2));
    const auto number = readInteger(cursor);
    if (number && cursor.accept('.'))
      return static_cast<std::uint16_t>(std::clamp<std::int64_t>(*number, 0, 65535));
  }
  cursor.seek(start);
  return std::nullopt;
}

// "DBX4.0", "M 10.0": area and bit address.
std::string_view place(Cursor& cursor) {
  cursor.skipBlanks();
  const std::size_t begin = cursor.pos();
  cursor.word();
  if (cursor.peek() != '.') {
    cursor.skipBlanks();
    while (isDigit(cursor.peek())) cursor.take();
  }
  if (cursor.peek() == '.')
    for (cursor.take(); isDigit(cursor.peek());) cursor.take();
  return cursor.slice(begin, cursor.pos());
}

// "WORD 5": what makes an ANY of it.
bool repetition(Cursor& cursor, PointerValue& out, const source::SourceFile& file,
                Problems& problems) {
  const std::size_t start = cursor.pos();
  cursor.skipBlanks();
  const std::size_t begin = cursor.pos();
  const auto type = typeFromName(cursor.word());
  if (!type) {
    cursor.seek(start);
    return true;
  }
  const auto count = readInteger(cursor);
  if (!count || *count < 0 || *count > 65535) {
    problems.add(ProblemCode::P0316,
                 file.position(begin, std::max(cursor.pos(), begin + 1) - begin));
    return false;
  }
  out.type = *type;
  out.count = static_cast<std::uint16_t>(*count);
  return true;
}

}  // namespace

std::optional<PointerValue> readPointer(Cursor& cursor, const source::SourceFile& file,
                                        Problems& problems) {
  const std::size_t start = cursor.pos();
  cursor.seek(start + 2);
  PointerValue out;
  out.db = dataBlock(cursor).value_or(0);
  const std::string text = "P#" + std::string(place(cursor));
  const auto value = parseConstant(text, file.position(start, cursor.pos() - start));
  if (!value) {
    problems.add(value.error());
    return std::nullopt;
  }
  out.pointer = value->bits;
  if (!repetition(cursor, out, file, problems)) return std::nullopt;
  return out;
}

}  // namespace merker::step7
