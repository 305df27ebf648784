#include "s7comm/item.h"

#include "base/bytes.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kVariable = 0x12, kAny = 0x10, kDbRead = 0xB0;
constexpr std::size_t kAnyLength = 10;  // behind the octet that says so
constexpr std::size_t kDbReadArea = 5;
constexpr std::uint32_t kMemoryEnd = 0x10000;  // no area has more bytes

bool isMemory(std::uint8_t code) {
  return code == static_cast<std::uint8_t>(Memory::Timer) ||
         code == static_cast<std::uint8_t>(Memory::Counter) || (code >= 0x80 && code <= 0x84);
}

Wanted refusedItem(ItemCode code) { return {.code = code}; }

Wanted cells(const ElementRow& element, Memory memory, std::uint32_t count, std::uint32_t number) {
  const auto own = static_cast<ElementType>(memory);  // the same codes
  if (element.type != own) return refusedItem(ItemCode::TypeNotSupported);
  if (count == 0 || number + count > kMemoryEnd) return refusedItem(ItemCode::OutOfRange);
  return {.ranges = {{.memory = memory, .begin = number, .octets = count * element.bytes}},
          .unit = element.answer};
}

// 65535 elements of 8 bytes fit into 32 bits: nothing is counted in less.
Wanted bytesOf(const ElementRow& element, Memory memory, std::uint32_t count, std::uint16_t block,
               std::uint32_t address) {
  const bool bit = element.type == ElementType::Bit;
  Range range{.memory = memory,
              .block = block,
              .begin = address / 8,
              .octets = count * element.bytes,
              .bit = static_cast<std::uint8_t>(address % 8),
              .oneBit = bit};
  if (bit && count > 1) return refusedItem(ItemCode::TypeMismatch);
  if (count == 0 || (!bit && range.bit != 0) || range.begin + range.octets > kMemoryEnd)
    return refusedItem(ItemCode::OutOfRange);
  return {.ranges = {range}, .unit = element.answer};
}

Wanted any(View item) {
  const ElementRow* const element = findElement(item[0]);
  const std::uint32_t count = loadWord(&item[1]);
  const std::uint16_t block = loadWord(&item[3]);
  const std::uint32_t address = loadDWord(&item[5]) & 0xFF'FFFF;
  if (element == nullptr || !isMemory(item[5])) return refusedItem(ItemCode::TypeNotSupported);
  const auto memory = static_cast<Memory>(item[5]);
  if (isCell(memory)) return cells(*element, memory, count, address);
  if (isCell(static_cast<Memory>(element->type))) return refusedItem(ItemCode::TypeNotSupported);
  return bytesOf(*element, memory, count, block, address);
}

// Number of areas, then length, data block and byte of each (as S7-400 clients ask).
Wanted dbRead(View item) {
  const std::size_t count = item.empty() ? 0 : item[0];
  if (count == 0 || item.size() != 1 + count * kDbReadArea)
    return refusedItem(ItemCode::TypeNotSupported);
  Wanted wanted{.unit = DataUnit::Byte, .areas = true};
  for (std::size_t i = 1; i < item.size(); i += kDbReadArea)
    wanted.ranges.push_back({.memory = Memory::DataBlock,
                             .block = loadWord(&item[i + 1]),
                             .begin = loadWord(&item[i + 3]),
                             .octets = item[i]});
  return wanted;
}

}  // namespace

std::uint32_t Wanted::octets() const {
  std::uint32_t sum = 0;
  for (const Range& range : ranges) sum += range.octets;
  return sum;
}

std::optional<Wanted> readItem(View& bytes) {
  if (bytes.size() < 2 || bytes[0] != kVariable || bytes.size() - 2 < bytes[1] || bytes[1] == 0)
    return std::nullopt;
  const std::uint8_t syntax = bytes[2];
  const View item = bytes.subspan(3, bytes[1] - 1u);
  bytes = bytes.subspan(2u + bytes[1]);
  if (syntax == kAny && item.size() == kAnyLength - 1) return any(item);
  if (syntax == kDbRead) return dbRead(item);
  return refusedItem(ItemCode::TypeNotSupported);
}

std::optional<std::vector<Wanted>> readItems(View& bytes, std::size_t count) {
  std::vector<Wanted> items;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = bytes.size();
    auto item = readItem(bytes);
    if (!item) return std::nullopt;
    items.push_back(std::move(*item));
    const bool odd = (before - bytes.size()) % 2 != 0;
    if (odd && i + 1 < count && !bytes.empty()) bytes = bytes.subspan(1);
  }
  return items;
}

void writeItem(Bytes& out, const AnyItem& item) {
  out.insert(out.end(), {kVariable, kAnyLength, kAny, static_cast<std::uint8_t>(item.type)});
  appendWord(out, item.count);
  appendWord(out, item.block);
  appendDWord(out, static_cast<std::uint32_t>(item.memory) << 24 | (item.address & 0xFF'FFFF));
}

}  // namespace merker::s7comm
