#include "monitor/data_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "awl/declaration_text.h"
#include "block/elements.h"
#include "mc5/constant.h"

namespace merker::monitor {
namespace {

using DataBytes = std::span<const std::uint8_t>;

constexpr std::size_t kMostVariables = 20'000;  // an answer has its limit; the rest is hex

std::string hex(DataBytes bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    text += fmt::format("{}{:02X}", i > 0 && i % 2 == 0 ? " " : "", bytes[i]);
  return text;
}

// "DBX 4.3", "DBW 6"; longer ones begin with a byte.
std::string placeOf(const block::Type& type, BitAddress at) {
  if (type.code == TypeCode::Bool) return fmt::format("DBX {}.{}", at / 8, at % 8);
  const std::uint32_t size = block::sizeInBytes(type);
  return fmt::format("{} {}", size == 2 ? "DBW" : size == 4 ? "DBD" : "DBB", at / 8);
}

// Rows of the variables that lie within the block; `end` becomes the byte behind the last one.
std::vector<MachineCodeRow> variableRows(const block::Block& block, std::size_t& end) {
  const DataBytes initial = block.initialData, actual = block.actualData;
  std::vector<MachineCodeRow> rows;
  block::forEachElement(block.variables, [&](const block::Element& element) {
    const block::Type& type = element.type;
    const std::size_t size = block::sizeInBytes(type), first = element.at / 8;
    if (rows.size() >= kMostVariables || first + size > actual.size()) return false;
    const DataBytes now = actual.subspan(first, size);
    const unsigned bit = element.at % 8;
    const bool begins = first + size <= initial.size();
    rows.push_back(
        {static_cast<std::uint32_t>(first), hex(now),
         fmt::format("{}  {} : {}", placeOf(type, element.at), element.path, awl::typeText(type)),
         0, begins ? awl::valueText(type, initial.subspan(first, size), bit) : "",
         awl::valueText(type, now, bit)});
    end = first + size;
    return true;
  });
  return rows;
}

class WordRows {
 public:
  explicit WordRows(const mc5::Block& block) : block_(block) {
    for (std::uint32_t at = 0; at < block.words.size();)
      at = block.texts.contains(at) ? characters(at) : constant(at);
  }

  std::vector<MachineCodeRow> rows;

 private:
  std::uint32_t add(std::uint32_t at, std::uint32_t count, std::string value) {
    const auto end = std::min<std::size_t>(at + count, block_.words.size());
    std::string code;
    for (std::size_t i = at; i < end; ++i)
      code += fmt::format("{}{:04X}", i == at ? "" : " ", block_.words[i]);
    rows.push_back({at, std::move(code), fmt::format("DW {}", at), 0, {}, std::move(value)});
    return static_cast<std::uint32_t>(end);
  }

  // KS = 'TEXT'
  std::uint32_t characters(std::uint32_t at) {
    const std::uint32_t count = std::max(block_.texts.at(at), 1u);
    std::string text;
    for (std::size_t i = at; i < std::min<std::size_t>(at + count, block_.words.size()); ++i)
      for (const int byte : {block_.words[i] >> 8, block_.words[i] & 0xFF})
        text += byte >= ' ' && byte <= '~' ? static_cast<char>(byte) : '?';
    return add(at, count, fmt::format("KS '{}'", text));
  }

  // KG takes two words.
  std::uint32_t constant(std::uint32_t at) {
    mc5::Format format = at < block_.formats.size() ? block_.formats[at] : mc5::Format::Hex;
    const bool isFloat = format == mc5::Format::Float;
    const bool pair = isFloat && at + 1 < block_.words.size();
    if (isFloat && !pair) format = mc5::Format::Hex;
    std::uint32_t value = block_.words[at];
    if (pair) value = value << 16 | block_.words[at + 1];
    return add(
        at, pair ? 2 : 1,
        mc5::constantText({.kind = mc5::OperandKind::Constant, .format = format, .value = value}));
  }

  const mc5::Block& block_;
};

}  // namespace

std::vector<MachineCodeRow> dataRows(const block::Block& block) {
  constexpr std::size_t kBytes = 16;
  std::size_t end = 0;
  std::vector<MachineCodeRow> rows = variableRows(block, end);
  const DataBytes all = block.actualData;
  const std::size_t rest = (end + 1) / 2 * 2;  // a block has an even length
  for (std::size_t at = rest; at < all.size(); at += kBytes)
    rows.push_back({static_cast<std::uint32_t>(at),
                    hex(all.subspan(at, std::min(kBytes, all.size() - at))),
                    {},
                    0,
                    {},
                    {}});
  return rows;
}

std::vector<MachineCodeRow> dataRows(const mc5::Block& block) {
  return std::move(WordRows(block).rows);
}

}  // namespace merker::monitor
