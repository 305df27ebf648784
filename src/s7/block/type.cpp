#include "block/type.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::block {
namespace {

constexpr std::uint32_t kWord = 16;
// Sizes stop growing here, far above any block, so that no declaration can make them wrap around.
constexpr std::uint32_t kHuge = 0x4000'0000;

std::uint32_t limited(std::uint64_t bits) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(bits, kHuge));
}

std::uint32_t roundUp(std::uint32_t value, std::uint32_t unit) {
  return (value + unit - 1) / unit * unit;
}

bool isBytePacked(TypeCode code) { return code == TypeCode::Byte || code == TypeCode::Char; }

// From one element to the next of the last dimension: bits and bytes packed, all else at even
// bytes.
std::uint32_t elementStride(const Type& element) {
  if (element.code == TypeCode::Bool) return 1;
  if (isBytePacked(element.code)) return 8;
  return roundUp(sizeInBits(element), kWord);
}

// Bits of one step in dimension `d`: all the elements of the dimensions behind it.
std::uint32_t dimensionStride(const Type& array, std::size_t d) {
  std::uint32_t stride = elementStride(*array.element);
  for (std::size_t i = array.dimensions.size(); i-- > d + 1;) {
    stride = limited(std::uint64_t{stride} * array.dimensions[i].count());
    if (array.element->code == TypeCode::Bool) stride = roundUp(stride, kWord);
  }
  return stride;
}

// Bits of the types that are not laid out by their parts.
std::uint32_t fixedSize(const Type& type) {
  switch (type.code) {
    case TypeCode::Bool:
      return 1;
    case TypeCode::Byte:
    case TypeCode::Char:
      return 8;
    case TypeCode::Word:
    case TypeCode::Int:
    case TypeCode::Date:
    case TypeCode::S5Time:
      return 16;
    case TypeCode::DWord:
    case TypeCode::DInt:
    case TypeCode::Real:
    case TypeCode::Time:
    case TypeCode::TimeOfDay:
      return 32;
    case TypeCode::DateAndTime:
      return 64;
    case TypeCode::String:
      return (type.length + 2u) * 8;
    case TypeCode::Pointer:
      return 6 * 8;
    case TypeCode::Any:
      return 10 * 8;
    default:
      return isParameterNumber(type.code) ? 16 : 0;
  }
}

bool sameMembers(const Type& a, const Type& b);

// As sameStructure, but lengths of strings count: inside of a structure they move what follows.
bool sameLayout(const Type& a, const Type& b) {
  if (a.code != b.code || a.length != b.length || a.dimensions != b.dimensions) return false;
  if ((a.element == nullptr) != (b.element == nullptr)) return false;
  return (a.element == nullptr || sameLayout(*a.element, *b.element)) && sameMembers(a, b);
}

bool sameMembers(const Type& a, const Type& b) {
  return std::equal(
      a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
      [](const Variable& x, const Variable& y) { return sameLayout(*x.type, *y.type); });
}

std::string dimensionsText(const Type& type) {
  std::string text;
  for (const Dimension& d : type.dimensions)
    text += fmt::format("{}{}..{}", text.empty() ? "" : ",", d.low, d.high);
  return text;
}

}  // namespace

std::uint32_t sizeInBits(const Type& type) { return type.bits; }

bool beginsAtWord(const Type& type) {
  return type.code != TypeCode::Bool && !isBytePacked(type.code);
}

BitAddress elementOffset(const Type& array, const std::vector<std::int32_t>& indices) {
  BitAddress offset = 0;
  for (std::size_t d = 0; d < array.dimensions.size() && d < indices.size(); ++d)
    offset += static_cast<std::uint32_t>(indices[d] - array.dimensions[d].low) *
              dimensionStride(array, d);
  return offset;
}

std::vector<BitAddress> elementOffsets(const Type& array) {
  std::vector<BitAddress> offsets{0};
  for (std::size_t d = 0; d < array.dimensions.size(); ++d) {
    const std::uint32_t stride = dimensionStride(array, d);
    std::vector<BitAddress> deeper;
    for (const BitAddress offset : offsets)
      for (std::uint32_t i = 0; i < array.dimensions[d].count(); ++i)
        deeper.push_back(offset + i * stride);
    offsets = std::move(deeper);
  }
  return offsets;
}

TypePtr elementaryType(TypeCode code) {
  Type type;
  type.code = code;
  type.bits = fixedSize(type);
  return std::make_shared<const Type>(std::move(type));
}

TypePtr stringType(std::uint16_t length) {
  Type type;
  type.code = TypeCode::String;
  type.length = length;
  type.bits = fixedSize(type);
  return std::make_shared<const Type>(std::move(type));
}

TypePtr arrayType(std::vector<Dimension> dimensions, TypePtr element) {
  Type type;
  type.code = TypeCode::Array;
  type.dimensions = std::move(dimensions);
  type.element = std::move(element);
  if (!type.dimensions.empty())
    type.bits = roundUp(
        limited(std::uint64_t{type.dimensions[0].count()} * dimensionStride(type, 0)), kWord);
  return std::make_shared<const Type>(std::move(type));
}

TypePtr structType(std::vector<Variable> members) {
  Type type;
  type.code = TypeCode::Struct;
  type.members = std::move(members);
  type.bits = layOut(type.members, 0, true);
  return std::make_shared<const Type>(std::move(type));
}

bool sameStructure(const Type& a, const Type& b) {
  if (a.code == TypeCode::String && b.code == TypeCode::String) return true;  // S7-PAR-04
  return sameLayout(a, b);
}

bool isStoredAsPointer(const Variable& variable) {
  if (variable.section != Section::InOut) return false;
  const TypeCode code = variable.type->code;
  return code == TypeCode::Array || code == TypeCode::Struct || code == TypeCode::String ||
         code == TypeCode::DateAndTime;
}

BitAddress layOut(std::vector<Variable>& variables, BitAddress start, bool roundUpEnd) {
  BitAddress next = start;
  for (Variable& variable : variables) {
    const Type& type = *variable.type;
    if (&variable != variables.data() && variable.section != (&variable - 1)->section)
      next = roundUp(next, kWord);
    const bool pointer = isStoredAsPointer(variable);
    const std::uint32_t unit = beginsAtWord(type) ? kWord : type.code == TypeCode::Bool ? 1 : 8;
    next = roundUp(next, unit);
    variable.address = next;
    next = limited(std::uint64_t{next} + (pointer ? 6 * 8 : sizeInBits(type)));
  }
  return roundUpEnd ? roundUp(next, kWord) : next;
}

std::string toString(const Type& type) {
  switch (type.code) {
    case TypeCode::Array:
      return fmt::format("ARRAY [{}] OF {}", dimensionsText(type), toString(*type.element));
    case TypeCode::String:
      return fmt::format("STRING [{}]", type.length);
    case TypeCode::Struct:
      return type.udt >= 0 ? fmt::format("UDT {}", type.udt) : "STRUCT";
    case TypeCode::FunctionBlock:
      return fmt::format("FB {}", type.length);
    case TypeCode::SystemFunctionBlock:
      return fmt::format("SFB {}", type.length);
    default:
      return std::string{name(type.code)};
  }
}

}  // namespace merker::block
