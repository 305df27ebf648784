#include "workbench/base64.h"

#include <algorithm>
#include <array>

namespace merker::workbench {
namespace {

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kBytes = 3, kLetters = 4;  // of a group
constexpr std::uint8_t kNoLetter = 0xFF;

constexpr auto kValues = [] {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoLetter);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  return values;
}();

}  // namespace

std::string toBase64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + kBytes - 1) / kBytes * kLetters);
  for (std::size_t at = 0; at < bytes.size(); at += kBytes) {
    const std::size_t count = std::min(kBytes, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < kBytes; ++i)
      group = group << 8 | (i < count ? bytes[at + i] : std::uint8_t{0});
    for (std::size_t i = 0; i < kLetters; ++i)
      text += i > count ? '=' : kAlphabet[group >> (18 - 6 * i) & 63];
  }
  return text;
}

std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text) {
  if (text.size() % kLetters != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / kLetters * kBytes);
  for (std::size_t at = 0; at < text.size(); at += kLetters) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < kLetters; ++i) {
      const bool pad = at + i >= text.size() - padding;
      const std::uint8_t value = pad ? 0 : kValues[static_cast<unsigned char>(text[at + i])];
      if (value == kNoLetter) return std::nullopt;
      group = group << 6 | value;
    }
    for (std::size_t i = 0; i < kBytes; ++i)
      bytes.push_back(static_cast<std::uint8_t>(group >> (16 - 8 * i)));
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace merker::workbench
