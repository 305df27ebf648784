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

// Of the variable of the block that the path begins with.
const block::Variable* outermost(const block::Block& block, std::string_view path) {
  const std::string_view name = path.substr(0, path.find_first_of(".["));
  const auto at = std::ranges::find(block.variables, name, &block::Variable::name);
  return at == block.variables.end() ? nullptr : &*at;
}

// Only a block with parameters shows what is one.
std::string sectionOf(const block::Block& block, std::string_view path) {
  constexpr std::string_view kNames[] = {"", "IN", "OUT", "IN_OUT", "STAT", "TEMP", "RETURN"};
  if (block.instanceOf < 0) return {};
  const block::Variable* variable = outermost(block, path);
  return variable == nullptr ? ""
                             : std::string(kNames[static_cast<std::size_t>(variable->section)]);
}

DataValue valueOf(const block::Block& block, const block::Element& element, DataBytes now) {
  const block::Type& type = element.type;
  const std::uint32_t first = element.at / 8, bit = element.at % 8;
  const DataBytes initial = block.initialData;
  const bool begins = first + now.size() <= initial.size();
  return {.byte = first,
          .bit = bit,
          .bytes = static_cast<std::uint32_t>(now.size()),
          .place = placeOf(type, element.at),
          .path = element.path,
          .type = awl::typeText(type),
          .section = sectionOf(block, element.path),
          .comment = element.name.comment,
          .code = hex(now),
          .initial = begins ? awl::valueText(type, initial.subspan(first, now.size()), bit) : "",
          .actual = awl::valueText(type, now, bit)};
}

class WordRows {
 public:
  explicit WordRows(const mc5::Block& block) : block_(block) {
    for (std::uint32_t at = 0; at < block.words.size();)
      at = block.texts.contains(at) ? characters(at) : constant(at);
  }

  std::vector<DataValue> values;

 private:
  std::uint32_t add(std::uint32_t at, std::uint32_t count, std::string value) {
    const auto end = std::min<std::size_t>(at + count, block_.words.size());
    std::string code;
    for (std::size_t i = at; i < end; ++i)
      code += fmt::format("{}{:04X}", i == at ? "" : " ", block_.words[i]);
    values.push_back({.byte = at,
                      .place = fmt::format("DW {}", at),
                      .type = value.substr(0, value.find(' ')),
                      .code = std::move(code),
                      .actual = std::move(value)});
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

// Without a type the place says all.
MachineCodeRow machineCodeRow(DataValue value) {
  std::string text = value.path.empty()
                         ? value.place
                         : fmt::format("{}  {} : {}", value.place, value.path, value.type);
  return {value.byte, std::move(value.code),    std::move(text),
          0,          std::move(value.initial), std::move(value.actual)};
}

}  // namespace

DataValues dataValues(const block::Block& block, DataBytes actual) {
  DataValues result;
  block::forEachElement(block.variables, [&](const block::Element& element) {
    const std::size_t size = block::sizeInBytes(element.type), first = element.at / 8;
    if (first + size > actual.size()) return false;
    if (result.values.size() >= kMostVariables)
      ++result.more;
    else
      result.values.push_back(valueOf(block, element, actual.subspan(first, size)));
    return true;
  });
  return result;
}

// To the walk, which leaves temporary variables out, they are those of a block of their own.
DataValues localValues(const block::Block& block, DataBytes local) {
  block::Block own;
  for (block::Variable variable : block.variables) {
    if (variable.section != block::Section::Temp) continue;
    variable.section = block::Section::Static;
    own.variables.push_back(std::move(variable));
  }
  return dataValues(own, local);
}

DataValues dataValues(const mc5::Block& block) { return {std::move(WordRows(block).values)}; }

// What no variable names comes behind the variables, in hex.
std::vector<MachineCodeRow> dataRows(const block::Block& block) {
  constexpr std::size_t kBytes = 16;
  std::vector<MachineCodeRow> rows;
  std::size_t end = 0;
  for (DataValue& value : dataValues(block, block.actualData).values) {
    end = value.byte + value.bytes;
    rows.push_back(machineCodeRow(std::move(value)));
  }
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
  std::vector<MachineCodeRow> rows;
  for (DataValue& value : dataValues(block).values)
    rows.push_back(machineCodeRow(std::move(value)));
  return rows;
}

}  // namespace merker::monitor
