// Bytes in a message (RFC 4648).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace merker::workbench {

std::string toBase64(std::span<const std::uint8_t> bytes);
// Nothing if it is no such text, padded to groups of four.
std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text);

}  // namespace merker::workbench
