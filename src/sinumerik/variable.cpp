#include "sinumerik/variable.h"

#include <fmt/format.h>

#include <span>

#include "sinumerik/system_blocks.h"

namespace merker::sinumerik {
namespace {

using mc5::Area;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Width;

unsigned bytesOf(Width width) {
  switch (width) {
    case Width::Double:
      return 4;
    case Width::Word:
      return 2;
    default:
      return 1;
  }
}

bool fits(const Operand& operand, std::size_t bytes) {
  return std::uint64_t{operand.value} + bytesOf(operand.width) <= bytes && operand.bit < 8;
}

std::optional<std::uint32_t> readBytes(std::span<const std::uint8_t> area, const Operand& operand) {
  if (!fits(operand, area.size())) return std::nullopt;
  if (operand.width == Width::Bit) return area[operand.value] >> operand.bit & 1;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bytesOf(operand.width); ++i)
    value = value << 8 | area[operand.value + i];
  return value;
}

// What one of the operand's bytes gets: mask and value.
struct ByteChange {
  std::size_t byte;
  std::uint8_t mask, value;
};

template <typename Apply>
bool eachByte(const Operand& operand, std::size_t size, std::uint32_t value, Apply apply) {
  if (!fits(operand, size)) return false;
  if (operand.width == Width::Bit) {
    const auto mask = static_cast<std::uint8_t>(1u << operand.bit);
    apply(ByteChange{operand.value, mask, value != 0 ? mask : std::uint8_t{0}});
    return true;
  }
  const unsigned bytes = bytesOf(operand.width);
  for (unsigned i = 0; i < bytes; ++i)
    apply(ByteChange{operand.value + i, 0xFF,
                     static_cast<std::uint8_t>(value >> (8 * (bytes - 1 - i)))});
  return true;
}

std::uint8_t changed(std::uint8_t byte, const ByteChange& change) {
  return static_cast<std::uint8_t>((byte & ~change.mask) | (change.value & change.mask));
}

// The words of the block from the operand on; empty if they are not all there.
std::optional<std::uint32_t> dataWord(const Machine& m, const Variable& v) {
  const Entry& entry = m.blocks.find({mc5::BlockType::Db, v.dataBlock});
  const std::uint32_t words = v.operand.width == Width::Double ? 2 : 1;
  if (!entry.present || std::uint64_t{v.operand.value} + words > entry.length || v.operand.bit > 15)
    return std::nullopt;
  return entry.start + v.operand.value;
}

std::optional<std::uint32_t> readData(const Machine& m, const Variable& v) {
  const auto at = dataWord(m, v);
  if (!at) return std::nullopt;
  const std::uint32_t word = m.blocks.data()[*at];
  switch (v.operand.width) {
    case Width::Bit:
      return word >> v.operand.bit & 1;
    case Width::Left:
      return word >> 8;
    case Width::Byte:
    case Width::Right:
      return word & 0xFF;
    case Width::Word:
      return word;
    case Width::Double:
      return word << 16 | m.blocks.data()[*at + 1];
  }
  return std::nullopt;
}

bool writeData(Machine& m, const Variable& v, std::uint32_t value) {
  const auto at = dataWord(m, v);
  if (!at) return false;
  std::uint16_t& word = m.blocks.data()[*at];
  const auto put = [&word](std::uint32_t mask, std::uint32_t bits) {
    word = static_cast<std::uint16_t>((word & ~mask) | (bits & mask));
  };
  switch (v.operand.width) {
    case Width::Bit:
      put(1u << v.operand.bit, value != 0 ? 0xFFFF : 0);
      break;
    case Width::Left:
      put(0xFF00, value << 8);
      break;
    case Width::Byte:
    case Width::Right:
      put(0x00FF, value);
      break;
    case Width::Word:
      put(0xFFFF, value);
      break;
    case Width::Double:
      put(0xFFFF, value >> 16);
      m.blocks.data()[*at + 1] = static_cast<std::uint16_t>(value);
      break;
  }
  return true;
}

template <typename Cells>
std::optional<std::uint32_t> readCell(const Cells& cells, const Operand& operand) {
  if (operand.value >= cells.size()) return std::nullopt;
  const auto& cell = cells[operand.value];
  return operand.width == Width::Bit ? std::uint32_t{cell.output()} : std::uint32_t{cell.coded()};
}

// As if a start operation had seen an edge.
bool writeCell(OperatingSystem& os, const Operand& operand, std::uint32_t value) {
  if (operand.value >= kCells || operand.width == Width::Bit) return false;
  const auto akku = static_cast<std::uint16_t>(value);
  if (operand.kind == OperandKind::Counter) {
    Counter& counter = os.machine().counters[operand.value];
    counter.set(false, 0);
    return counter.set(true, akku);
  }
  Timer& timer = os.machine().timers[operand.value];
  timer.reset(true);
  return timer.start(TimerKind::SV, false, 0, os.machine().clock, os.timeBases()) ||
         timer.start(TimerKind::SV, true, akku, os.machine().clock, os.timeBases());
}

}  // namespace

std::string whySystemOwned(const OperatingSystem& os, const Variable& v) {
  const bool data = v.operand.kind == OperandKind::Memory && v.operand.area == Area::Data;
  if (!data || !isSystemBlock(v.dataBlock, os.options().systemBlocks)) return {};
  const bool trigger = v.dataBlock == diagnosis::kDb && v.operand.value == diagnosis::kTrigger &&
                       v.operand.width != Width::Double;
  if (trigger) return {};
  return fmt::format("DB {} belongs to the system; only DW 9 of DB 1 takes a value", v.dataBlock);
}

std::optional<std::uint32_t> readValue(const OperatingSystem& os, const Variable& v) {
  const Machine& m = os.machine();
  if (v.operand.kind == OperandKind::Timer) return readCell(m.timers, v.operand);
  if (v.operand.kind == OperandKind::Counter) return readCell(m.counters, v.operand);
  if (v.operand.kind != OperandKind::Memory) return std::nullopt;
  switch (v.operand.area) {
    case Area::Input:
      return readBytes(m.inputs, v.operand);
    case Area::Output:
      return readBytes(m.outputs, v.operand);
    case Area::Flag:
      return readBytes(m.flags, v.operand);
    case Area::Data:
      return readData(m, v);
    case Area::Peripheral: {
      const auto value = readBytes(m.periphery.outputs, v.operand);
      return value && os.mode() != Mode::Run ? std::optional(0u) : value;
    }
    case Area::None:
      break;
  }
  return std::nullopt;
}

bool writeValue(OperatingSystem& os, const Variable& v, std::uint32_t value) {
  Machine& m = os.machine();
  const OperandKind kind = v.operand.kind;
  if (kind == OperandKind::Timer || kind == OperandKind::Counter)
    return writeCell(os, v.operand, value);
  if (kind != OperandKind::Memory) return false;
  const auto into = [&](auto& area) {
    return eachByte(v.operand, area.size(), value,
                    [&](ByteChange c) { area[c.byte] = changed(area[c.byte], c); });
  };
  switch (v.operand.area) {
    case Area::Input:
    case Area::Peripheral:
      return eachByte(v.operand, kImageBytes, value, [&](ByteChange c) {
        os.setTerminal(static_cast<unsigned>(c.byte), changed(m.periphery.inputs[c.byte], c));
      });
    case Area::Output:
      return into(m.outputs);
    case Area::Flag:
      return into(m.flags);
    case Area::Data:
      return writeData(m, v, value);
    case Area::None:
      break;
  }
  return false;
}

bool forceValue(OperatingSystem& os, const Variable& v, std::uint32_t value) {
  Machine& m = os.machine();
  if (v.operand.kind != OperandKind::Memory) return false;
  const auto hold = [&](auto& forces, auto& area) {
    const bool known = eachByte(v.operand, area.size(), value,
                                [&](ByteChange c) { forces.set(c.byte, c.mask, c.value); });
    forces.apply(area);
    return known;
  };
  switch (v.operand.area) {
    case Area::Input:
      return hold(os.forcedInputs, m.inputs);
    case Area::Output:
      return hold(os.forcedOutputs, m.outputs);
    case Area::Flag:
      return hold(os.forcedFlags, m.flags);
    default:
      return false;
  }
}

}  // namespace merker::sinumerik
