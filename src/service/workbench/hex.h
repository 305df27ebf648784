// Bytes as hexadecimal digits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace merker::workbench {

std::string toHex(std::span<const std::uint8_t> bytes);
// Nothing if it is no such text.
std::optional<std::vector<std::uint8_t>> fromHex(std::string_view text);

}  // namespace merker::workbench
