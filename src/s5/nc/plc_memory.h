// Flags and data blocks of the PLC as macros reach them.
#pragma once

#include <cstdint>
#include <span>

#include "softplc/machine.h"

namespace merker::nc {

constexpr unsigned kFirstTransferFlag = 224;  // MB 224 … 255 belong to the macros (S5-FLAG-12)

inline std::uint16_t flagWord(const sinumerik::Machine& m, unsigned byte) {
  return static_cast<std::uint16_t>(m.flags.at(byte) << 8 | m.flags.at(byte + 1));
}
inline void setFlagWord(sinumerik::Machine& m, unsigned byte, std::uint32_t word) {
  m.flags.at(byte) = static_cast<std::uint8_t>(word >> 8);
  m.flags.at(byte + 1) = static_cast<std::uint8_t>(word);
}

inline bool hasDataBlock(const sinumerik::Machine& m, std::uint16_t number) {
  return m.blocks.find({mc5::BlockType::Db, number}).present;
}
// Its words; none if it is missing.
inline std::span<std::uint16_t> dataBlock(sinumerik::Machine& m, std::uint16_t number) {
  const sinumerik::Entry& entry = m.blocks.find({mc5::BlockType::Db, number});
  if (!entry.present) return {};
  return std::span(m.blocks.data()).subspan(entry.start, entry.length);
}

constexpr std::uint8_t highByte(std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); }
constexpr std::uint8_t lowByte(std::uint16_t word) { return static_cast<std::uint8_t>(word); }

}  // namespace merker::nc
