#include "softplc/variable.h"

#include <fmt/format.h>

#include <span>

#include "plc/cell_value.h"
#include "softplc/system_blocks.h"

namespace merker::sinumerik {
namespace {

using address::Operand;
using address::OperandKind;

std::uint32_t byteOf(const Operand& operand) { return operand.value / 8; }

bool fits(const Operand& operand, std::size_t bytes) {
  return std::uint64_t{byteOf(operand)} + byteCount(operand.width) <= bytes;
}

// `at` gives the bytes of an area, the high one first.
template <typename At>
std::uint32_t readBytes(const Operand& operand, At at) {
  if (operand.width == Width::Bit) return at(byteOf(operand)) >> (operand.value & 7) & 1u;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < byteCount(operand.width); ++i)
    value = value << 8 | at(byteOf(operand) + i);
  return value;
}

std::optional<std::uint32_t> readArea(std::span<const std::uint8_t> area, const Operand& operand) {
  if (!fits(operand, area.size())) return std::nullopt;
  return readBytes(operand, [area](std::uint32_t byte) { return area[byte]; });
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
    const auto mask = static_cast<std::uint8_t>(1u << (operand.value & 7));
    apply(ByteChange{byteOf(operand), mask, value != 0 ? mask : std::uint8_t{0}});
    return true;
  }
  const unsigned bytes = byteCount(operand.width);
  for (unsigned i = 0; i < bytes; ++i)
    apply(ByteChange{byteOf(operand) + i, 0xFF,
                     static_cast<std::uint8_t>(value >> (8 * (bytes - 1 - i)))});
  return true;
}

std::uint8_t changed(std::uint8_t byte, const ByteChange& change) {
  return static_cast<std::uint8_t>((byte & ~change.mask) | (change.value & change.mask));
}

// The first word of the block the operand lies in; nothing if the block has not all of it. Words
// and double words begin at a word.
std::optional<std::uint32_t> firstWord(const Machine& m, const Reference& r) {
  const std::uint32_t byte = byteOf(r.operand), count = byteCount(r.operand.width);
  if (r.db < 0 || (count > 1 && byte % 2 != 0)) return std::nullopt;
  const Entry& entry = m.blocks.find({mc5::BlockType::Db, static_cast<std::uint16_t>(r.db)});
  if (!entry.present || (std::uint64_t{byte} + count + 1) / 2 > entry.length) return std::nullopt;
  return entry.start;
}

// The left byte of a word is the high one (S5-BLK-10).
unsigned shiftOf(std::uint32_t byte) { return byte % 2 == 0 ? 8 : 0; }

std::optional<std::uint32_t> readData(const Machine& m, const Reference& r) {
  const auto first = firstWord(m, r);
  if (!first) return std::nullopt;
  return readBytes(r.operand, [&](std::uint32_t byte) {
    return static_cast<std::uint8_t>(m.blocks.data()[*first + byte / 2] >> shiftOf(byte));
  });
}

bool writeData(Machine& m, const Reference& r, std::uint32_t value) {
  const auto first = firstWord(m, r);
  if (!first) return false;
  return eachByte(r.operand, SIZE_MAX, value, [&](ByteChange c) {
    const auto byte = static_cast<std::uint32_t>(c.byte);
    std::uint16_t& word = m.blocks.data()[*first + byte / 2];
    const unsigned shift = shiftOf(byte);
    word = static_cast<std::uint16_t>((word & ~(c.mask << shift)) | c.value << shift);
  });
}

template <typename Cells>
std::optional<std::uint32_t> readCell(const Cells& cells, const Operand& operand) {
  if (operand.value >= cells.size()) return std::nullopt;
  const auto& cell = cells[operand.value];
  return operand.width == Width::Bit ? std::uint32_t{cell.output()} : std::uint32_t{cell.coded()};
}

// Whether modules have all bytes of the terminal. Beyond the periphery the inputs of the NC are
// always there.
bool hasTerminal(const Machine& m, const Operand& operand) {
  if (!fits(operand, kImageBytes)) return false;
  const std::uint32_t first = byteOf(operand);
  const bool ofNc = operand.area == Area::Input;
  for (std::uint32_t byte = first; byte < first + byteCount(operand.width); ++byte)
    if (byte < kPeripheryBytes ? !m.periphery.inputPresent[byte] : !ofNc) return false;
  return true;
}

// As if a start operation had seen an edge.
bool writeCell(OperatingSystem& os, const Operand& operand, std::uint32_t value) {
  if (operand.value >= kCells || operand.width == Width::Bit ||
      !controller::isCellValue(operand.kind, value))
    return false;
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

std::string whySystemOwned(const OperatingSystem& os, const Reference& r) {
  if (r.db < 0 || !isSystemBlock(static_cast<std::uint16_t>(r.db), os.options().systemBlocks))
    return {};
  const bool trigger = r.db == diagnosis::kDb && byteOf(r.operand) / 2 == diagnosis::kTrigger &&
                       r.operand.width != Width::DWord;
  if (trigger) return {};
  return fmt::format("DB {} belongs to the system; only DW 9 of DB 1 can be written", r.db);
}

std::string whyMissing(const OperatingSystem& os, const Reference& r) {
  if (!address::isMemory(r.operand) || r.operand.area != Area::DataBlock)
    return "it is outside the areas of this PLC";
  const auto& entry =
      os.machine().blocks.find({mc5::BlockType::Db, static_cast<std::uint16_t>(r.db)});
  return entry.present ? fmt::format("DB {} has {} words", r.db, entry.length)
                       : fmt::format("there is no DB {}", r.db);
}

std::string whyRefused(const OperatingSystem& os, const Reference& r) {
  if (address::isTimer(r.operand)) return "it takes KT 000.0 to KT 999.3";
  if (address::isCounter(r.operand)) return "it takes KZ 000 to KZ 999";
  const bool terminal = r.operand.area == Area::Input || r.operand.area == Area::Peripheral;
  if (terminal && !hasTerminal(os.machine(), r.operand)) return "no input module has this address";
  return whySystemOwned(os, r);
}

std::optional<std::uint32_t> readValue(const OperatingSystem& os, const Reference& r) {
  const Machine& m = os.machine();
  if (r.operand.kind == OperandKind::Timer) return readCell(m.timers, r.operand);
  if (r.operand.kind == OperandKind::Counter) return readCell(m.counters, r.operand);
  if (r.operand.kind != OperandKind::Memory) return std::nullopt;
  switch (r.operand.area) {
    case Area::Input:
      return readArea(m.inputs, r.operand);
    case Area::Output:
      return readArea(m.outputs, r.operand);
    case Area::Flag:
      return readArea(m.flags, r.operand);
    case Area::DataBlock:
      return readData(m, r);
    case Area::Peripheral: {
      const auto value = readArea(m.periphery.outputs, r.operand);
      return value && os.mode() != Mode::Run ? std::optional(0u) : value;
    }
    default:
      break;
  }
  return std::nullopt;
}

bool writeValue(OperatingSystem& os, const Reference& r, std::uint32_t value) {
  Machine& m = os.machine();
  const OperandKind kind = r.operand.kind;
  if (kind == OperandKind::Timer || kind == OperandKind::Counter)
    return writeCell(os, r.operand, value);
  if (kind != OperandKind::Memory) return false;
  const auto into = [&](auto& area) {
    return eachByte(r.operand, area.size(), value,
                    [&](ByteChange c) { area[c.byte] = changed(area[c.byte], c); });
  };
  switch (r.operand.area) {
    case Area::Input:
    case Area::Peripheral:
      return hasTerminal(m, r.operand) &&
             eachByte(r.operand, kImageBytes, value, [&](ByteChange c) {
               os.setTerminal(static_cast<unsigned>(c.byte),
                              changed(m.periphery.inputs[c.byte], c));
             });
    case Area::Output:
      return into(m.outputs);
    case Area::Flag:
      return into(m.flags);
    case Area::DataBlock:
      return writeData(m, r, value);
    default:
      break;
  }
  return false;
}

bool writeImage(OperatingSystem& os, const Reference& r, std::uint32_t value) {
  std::array<std::uint8_t, kImageBytes>& inputs = os.machine().inputs;
  if (r.operand.kind != OperandKind::Memory || r.operand.area != Area::Input)
    return writeValue(os, r, value);
  return eachByte(r.operand, inputs.size(), value,
                  [&](ByteChange c) { inputs[c.byte] = changed(inputs[c.byte], c); });
}

bool forceValue(OperatingSystem& os, const Reference& r, std::uint32_t value) {
  Machine& m = os.machine();
  if (r.operand.kind != OperandKind::Memory) return false;
  const auto hold = [&](auto& forces, auto& area) {
    const bool known = eachByte(r.operand, area.size(), value,
                                [&](ByteChange c) { forces.set(c.byte, c.mask, c.value); });
    forces.apply(area);
    return known;
  };
  switch (r.operand.area) {
    case Area::Input:
      return hold(os.forces().inputs, m.inputs);
    case Area::Output:
      return hold(os.forces().outputs, m.outputs);
    case Area::Flag:
      return hold(os.forces().flags, m.flags);
    default:
      return false;
  }
}

}  // namespace merker::sinumerik
