#include "s7p/variable_table.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace merker::s7p {
namespace {

// A row: area, width, byte, bit, data block, and more that is not known.
enum Field : std::size_t { AreaAt, WidthAt, ByteAt, BitAt, DbAt, Needed };
using Fields = std::array<unsigned, Needed>;

bool parse(std::string_view row, Fields& fields) {
  for (unsigned& field : fields) {
    while (row.starts_with(' ')) row.remove_prefix(1);
    const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), field);
    if (error != std::errc()) return false;
    row.remove_prefix(static_cast<std::size_t>(end - row.data()));
  }
  return true;
}

constexpr unsigned kDataBlock = 5, kTimer = 8, kCounter = 9, kBit = 1;

// Empty if it is none that is known.
std::string operand(const Fields& f) {
  static constexpr std::array<std::string_view, 5> kAreas{"", "", "E", "A", "M"};
  static constexpr std::array<std::string_view, 5> kWidths{"", "", "B", "W", "D"};
  if (f[AreaAt] == kTimer) return fmt::format("T {}", f[ByteAt]);
  if (f[AreaAt] == kCounter) return fmt::format("Z {}", f[ByteAt]);
  if (f[WidthAt] < kBit || f[WidthAt] >= kWidths.size() || f[BitAt] > 7) return {};
  const bool bit = f[WidthAt] == kBit;
  const std::string place =
      bit ? fmt::format("{}.{}", f[ByteAt], f[BitAt]) : std::to_string(f[ByteAt]);
  if (f[AreaAt] == kDataBlock)
    return fmt::format("DB{}.DB{} {}", f[DbAt], bit ? "X" : kWidths[f[WidthAt]], place);
  if (f[AreaAt] < 2 || f[AreaAt] >= kAreas.size()) return {};
  return fmt::format("{}{} {}", kAreas[f[AreaAt]], kWidths[f[WidthAt]], place);
}

}  // namespace

VariableTable readVariableTable(std::uint16_t number, std::span<const std::uint8_t> rows) {
  VariableTable table;
  table.number = number;
  std::string_view rest(reinterpret_cast<const char*>(rows.data()), rows.size());
  for (bool header = true; !rest.empty(); header = false) {
    const std::string_view row = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(std::min(row.size() + 1, rest.size()));
    if (header || row.empty()) continue;
    Fields fields{};
    const std::string text = parse(row, fields) ? operand(fields) : std::string();
    text.empty() ? void(++table.unknown) : table.operands.push_back(text);
  }
  return table;
}

}  // namespace merker::s7p
