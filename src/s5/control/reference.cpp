#include "control/reference.h"

#include <charconv>

#include "nc/datum.h"
#include "step5/variable.h"

namespace merker::cnc {
namespace {

ConstantFormat formatOf(mc5::Format format) {
  switch (format) {
    case mc5::Format::Byte:
    case mc5::Format::SignedByte:
      return ConstantFormat::Byte;
    case mc5::Format::Fixed:
      return ConstantFormat::Integer;
    case mc5::Format::Float:
      return ConstantFormat::DWord;
    case mc5::Format::Time:  // base and three digits, as those of S5T#
      return ConstantFormat::S5Time;
    case mc5::Format::Counter:
      return ConstantFormat::Counter;
    default:
      return ConstantFormat::Word;
  }
}

// Whole numbers beyond 16 bits need no L# here: data double words of STEP 5 have no type.
std::optional<Constant> longInteger(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || (value >= INT16_MIN && value <= INT16_MAX)) return std::nullopt;
  if (value < INT32_MIN || value > UINT32_MAX) return std::nullopt;
  return Constant{ConstantFormat::LongInteger, static_cast<std::uint32_t>(value)};
}

}  // namespace

std::optional<address::Reference> datumReference(std::string_view text) {
  const auto datum = nc::parseDatum(text);
  if (!datum) return std::nullopt;
  address::Reference reference;
  reference.text = text;
  reference.operand.kind = address::OperandKind::Memory;
  reference.nc = nc::pack(*datum);
  return reference;
}

std::optional<Constant> parseConstant(std::string_view text) {
  const auto operand = step5::parseConstant(text);
  if (!operand) return longInteger(text);
  return Constant{formatOf(operand->format), operand->value};
}

}  // namespace merker::cnc
