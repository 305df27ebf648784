// Bytes as they are on the wire, written by hand: "03 00 00 16".
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "iso/tpdu.h"

namespace merker::iso {

inline Bytes hex(std::string_view text) {
  Bytes bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ') continue;
    unsigned value = 0;
    std::from_chars(text.data() + i, text.data() + i + 2, value, 16);
    bytes.push_back(static_cast<std::uint8_t>(value));
    ++i;
  }
  return bytes;
}

inline std::string toHex(View bytes) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    if (!text.empty()) text += ' ';
    text += {kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return text;
}

// What S7 clients ask with: TPDU size 1024, TSAPs of a PG and of rack 0 slot 2.
constexpr std::string_view kRequest =
    "03 00 00 16 11 E0 00 00 00 05 00 C0 01 0A C1 02 01 00 C2 02 01 02";
constexpr std::string_view kConfirm =
    "03 00 00 16 11 D0 00 05 00 01 00 C0 01 0A C1 02 01 00 C2 02 01 02";

}  // namespace merker::iso
