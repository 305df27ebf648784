// How requests name blocks: the character of the type, five digits, the file system.
#pragma once

#include <optional>
#include <string>

#include "s7comm/block_store.h"

namespace merker::s7comm {

inline std::optional<BlockType> blockTypeOf(std::uint8_t character) {
  const bool known = character == '8' || (character >= 'A' && character <= 'F');
  return known ? std::optional(static_cast<BlockType>(character)) : std::nullopt;
}

inline std::optional<FileSystem> fileSystemOf(std::uint8_t character) {
  const bool known = character == 'A' || character == 'B' || character == 'P';
  return known ? std::optional(static_cast<FileSystem>(character)) : std::nullopt;
}

// "0", type, number, file system: 8 characters. Nothing: it is no name.
inline std::optional<BlockName> blockNameOf(View text) {
  constexpr std::size_t kName = 8, kDigits = 2, kFileSystem = 7;
  if (text.size() != kName || text[0] != '0') return std::nullopt;
  const auto type = blockTypeOf(text[1]);
  std::uint32_t number = 0;
  for (const std::uint8_t digit : text.subspan(kDigits, kFileSystem - kDigits)) {
    if (digit < '0' || digit > '9') return std::nullopt;
    number = number * 10 + digit - '0';
  }
  const auto files = fileSystemOf(text[kFileSystem]);
  if (!type || !files || number > 0xFFFF) return std::nullopt;
  return BlockName{*type, static_cast<std::uint16_t>(number), *files};
}

// The same text: "0A00001P".
inline std::string textOf(const BlockName& name) {
  const std::string digits = std::to_string(100'000 + name.number);
  return std::string{'0', static_cast<char>(name.type)} + digits.substr(1) +
         static_cast<char>(name.files);
}

}  // namespace merker::s7comm
