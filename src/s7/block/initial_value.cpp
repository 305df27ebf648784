// Start values of variables, written into the bytes of a frame.
#include <algorithm>
#include <array>

#include "block/type.h"

namespace merker::block {
namespace {

// Larger frames do not exist (data blocks end at 64 KB); their declaration is refused elsewhere.
constexpr std::uint32_t kLargestFrame = bitAddress(0x10'0000);

using Image = std::vector<std::uint8_t>;

// DT#1990-01-01-00:00:00.000, a Monday (weekday 2, S7-TYPES-18).
constexpr std::array<std::uint8_t, 8> kDefaultDateAndTime{0x90, 0x01, 0x01, 0, 0, 0, 0, 0x02};

void makeRoom(Image& image, BitAddress end) {
  if (image.size() * 8 < end) image.resize((end + 7) / 8);
}

void copyBytes(const std::uint8_t* from, std::size_t count, BitAddress to, Image& image) {
  std::copy_n(from, count, image.begin() + to / 8);
}

void writeDefault(const Type& type, BitAddress at, Image& image);

// Each element on its own: elements may be strings or structures with start values.
void writeElements(const Type& array, BitAddress at, Image& image) {
  if (isElementary(array.element->code)) return;
  for (const BitAddress offset : elementOffsets(array))
    writeDefault(*array.element, at + offset, image);
}

void writeDefault(const Type& type, BitAddress at, Image& image) {
  switch (type.code) {
    case TypeCode::String:
      image[at / 8] = static_cast<std::uint8_t>(type.length);
      return;
    case TypeCode::DateAndTime:
      copyBytes(kDefaultDateAndTime.data(), kDefaultDateAndTime.size(), at, image);
      return;
    case TypeCode::Array:
      writeElements(type, at, image);
      return;
    default:
      for (const Variable& member : type.members) writeInitial(member, at + member.address, image);
  }
}

}  // namespace

void writeInitial(const Variable& variable, BitAddress place, Image& image) {
  const Type& type = *variable.type;
  const std::uint32_t size = isStoredAsPointer(variable) ? 6 * 8 : sizeInBits(type);
  if (size == 0) return;  // a type with a problem
  if (place > kLargestFrame || size > kLargestFrame - place) return;
  makeRoom(image, place + size);
  if (isStoredAsPointer(variable)) return;
  if (!variable.hasInitial || variable.initial.empty()) {
    writeDefault(type, place, image);
  } else if (type.code == TypeCode::Bool) {
    const auto mask = static_cast<std::uint8_t>(1 << place % 8);
    if ((variable.initial[0] & 1) != 0) image[place / 8] |= mask;
  } else {
    const std::size_t count = std::min<std::size_t>(variable.initial.size(), sizeInBytes(type));
    copyBytes(variable.initial.data(), count, place, image);
  }
}

}  // namespace merker::block
