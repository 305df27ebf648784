#include "source/dos_text.h"

#include <map>

namespace merker::source {
namespace {

using Bytes = std::map<std::string, char, std::less<>>;

// Each character beyond ASCII with its byte.
Bytes bytesOf(Encoding codePage) {
  Bytes bytes;
  for (int byte = 0x80; byte <= 0xFF; ++byte) {
    const char c = static_cast<char>(byte);
    bytes.emplace(toUtf8(std::string_view(&c, 1), codePage), c);
  }
  return bytes;
}

const Bytes& tableOf(Encoding codePage) {
  static const Bytes k850 = bytesOf(Encoding::Cp850), k437 = bytesOf(Encoding::Cp437);
  return codePage == Encoding::Cp850 ? k850 : k437;
}

std::size_t lengthOf(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  if (byte >= 0xF0) return 4;
  if (byte >= 0xE0) return 3;
  return byte >= 0xC0 ? 2 : 1;
}

}  // namespace

std::string toDos(std::string_view utf8, Encoding codePage) {
  const Bytes& table = tableOf(codePage);
  std::string text;
  while (!utf8.empty()) {
    const std::string_view character = utf8.substr(0, lengthOf(utf8.front()));
    utf8.remove_prefix(character.size());
    const auto found = table.find(character);
    const bool ascii = character.size() == 1 && static_cast<unsigned char>(character[0]) < 0x80;
    text += ascii ? character[0] : found == table.end() ? '?' : found->second;
  }
  return text;
}

}  // namespace merker::source
