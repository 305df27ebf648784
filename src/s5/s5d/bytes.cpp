#include "s5d/bytes.h"

namespace merker::s5d {

void setWord(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value) {
  bytes[at] = static_cast<std::uint8_t>(value >> 8);
  bytes[at + 1] = static_cast<std::uint8_t>(value);
}

void setLittle(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value) {
  bytes[at] = static_cast<std::uint8_t>(value);
  bytes[at + 1] = static_cast<std::uint8_t>(value >> 8);
}

void addWord(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

void putHead(std::vector<std::uint8_t>& bytes, const Kind& kind, std::uint16_t number,
             std::uint32_t library) {
  const auto words = static_cast<std::uint32_t>(bytes.size() / 2);
  bytes[kind.sync ? kNumber : kPreNumber] = static_cast<std::uint8_t>(number);
  setWord(bytes, kind.sync ? kLength : kPreLength, words);
  if (!kind.sync) {
    bytes[0] = kind.mark;
    return;
  }
  bytes[0] = bytes[1] = kSync;
  bytes[kType] = kind.mark;
  bytes[kLibrary] = static_cast<std::uint8_t>(library >> 16);
  setWord(bytes, kLibrary + 1, library & 0xFFFF);
}

}  // namespace merker::s5d
