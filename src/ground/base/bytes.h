// Big-endian access, the byte order of S7 memory: the high byte lies at the lower address.
#pragma once

#include <cstdint>
#include <vector>

namespace merker {

inline std::uint16_t loadWord(const std::uint8_t* p) {
  return static_cast<std::uint16_t>(p[0] << 8 | p[1]);
}
inline std::uint32_t loadDWord(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) << 24 | static_cast<std::uint32_t>(p[1]) << 16 |
         static_cast<std::uint32_t>(p[2]) << 8 | p[3];
}
inline void storeWord(std::uint8_t* p, std::uint32_t value) {
  p[0] = static_cast<std::uint8_t>(value >> 8);
  p[1] = static_cast<std::uint8_t>(value);
}
inline void storeDWord(std::uint8_t* p, std::uint32_t value) {
  storeWord(p, value >> 16);
  storeWord(p + 2, value);
}
inline void appendWord(std::vector<std::uint8_t>& out, std::uint32_t value) {
  out.push_back(static_cast<std::uint8_t>(value >> 8));
  out.push_back(static_cast<std::uint8_t>(value));
}
inline void appendDWord(std::vector<std::uint8_t>& out, std::uint32_t value) {
  appendWord(out, value >> 16);
  appendWord(out, value);
}

}  // namespace merker
