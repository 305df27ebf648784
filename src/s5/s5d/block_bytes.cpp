#include "s5d/block_bytes.h"

#include <fmt/format.h>

#include <array>

#include "mc5/constant.h"
#include "s5d/bytes.h"
#include "s5d/format_code.h"
#include "source/dos_text.h"

namespace merker::s5d {
namespace {

using mc5::Format;
using mc5::Parameter;
using mc5::ParameterKind;
using mc5::Width;

// Section 2.2.
struct KindCode {
  std::uint8_t code;
  ParameterKind kind;
};
constexpr std::array kKinds{KindCode{2, ParameterKind::Input},   KindCode{8, ParameterKind::Output},
                            KindCode{4, ParameterKind::Data},    KindCode{5, ParameterKind::Timer},
                            KindCode{6, ParameterKind::Counter}, KindCode{7, ParameterKind::Block}};

struct WidthCode {
  std::uint8_t code;
  Width width;
};
constexpr std::array kWidths{WidthCode{0x80, Width::Bit}, WidthCode{0x40, Width::Byte},
                             WidthCode{0x20, Width::Word}, WidthCode{0x10, Width::Double}};

constexpr std::array kParameterFormats{
    FormatCode{0x01, Format::Counter},    FormatCode{0x02, Format::Time},
    FormatCode{0x04, Format::Fixed},      FormatCode{0x08, Format::Float},
    FormatCode{0x10, Format::Characters}, FormatCode{0x20, Format::Bytes},
    FormatCode{0x40, Format::Hex},        FormatCode{0x80, Format::Binary}};

constexpr std::size_t kJumpWords = 5, kParameterWords = 3;  // over name and parameters
constexpr std::size_t kNameBytes = 8, kParameterName = 4;
constexpr std::size_t kFbName = kBody + 2, kFbParameters = kBody + 10;
constexpr std::uint16_t kJump = 0x2D00, kEnd = 0x6500;
constexpr std::size_t kMostParameters = 40;  // S5-FB-07

std::string textAt(Bytes bytes, std::size_t at, std::size_t length, Encoding codePage) {
  std::string text;
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint8_t byte = byteAt(bytes, at + i);
    text += static_cast<char>(byte < ' ' ? ' ' : byte);
  }
  return std::string(trim(toUtf8(text, codePage)));
}

bool typeOf(std::uint8_t code, Parameter& parameter) {
  const bool data = parameter.kind == ParameterKind::Data;
  const bool signal =
      parameter.kind == ParameterKind::Input || parameter.kind == ParameterKind::Output;
  if (!data && !signal) return true;
  for (const WidthCode& row : kWidths)
    if (signal && row.code == code) return parameter.width = row.width, true;
  for (const FormatCode& row : kParameterFormats)
    if (data && row.code == code) return parameter.format = row.format, true;
  return false;
}

bool kindFrom(std::uint8_t code, Parameter& parameter) {
  for (const KindCode& row : kKinds)
    if (row.code == code) return parameter.kind = row.kind, true;
  return false;
}

// SPA = over the name and the parameters; how many parameters, nothing if it is none.
std::optional<std::size_t> parameterCount(Bytes bytes) {
  const std::uint16_t jump = wordAt(bytes, kBody);
  const std::size_t distance = jump & 0xFFu;
  const bool forwards = (jump & 0xFF00u) == kJump && distance >= kJumpWords &&
                        (distance - kJumpWords) % kParameterWords == 0;
  const std::size_t count = forwards ? (distance - kJumpWords) / kParameterWords : 0;
  if (!forwards || count > kMostParameters || kBody + 2 * distance > bytes.size())
    return std::nullopt;
  return count;
}

// The offset of the code; 0 and a reason if the head is damaged.
std::size_t readHead(Bytes bytes, Encoding codePage, mc5::Block& block, std::string& reason) {
  const auto count = parameterCount(bytes);
  if (!count) {
    reason = "the list of its parameters is damaged";
    return 0;
  }
  block.name = textAt(bytes, kFbName, kNameBytes, codePage);
  for (std::size_t i = 0; i < *count; ++i) {
    const std::size_t at = kFbParameters + 6 * i;
    Parameter parameter;
    parameter.name = textAt(bytes, at + 2, kParameterName, codePage);
    if (!kindFrom(byteAt(bytes, at), parameter) || !typeOf(byteAt(bytes, at + 1), parameter)) {
      reason = fmt::format("its parameter '{}' has the unknown kind {:02X} {:02X}", parameter.name,
                           byteAt(bytes, at), byteAt(bytes, at + 1));
      return 0;
    }
    block.parameters.push_back(std::move(parameter));
  }
  return kFbParameters + 6 * *count;
}

std::string damageOf(const Record& record) {
  if (record.cut) return "the file ends before it does";
  if (record.bytes.size() < kBody) return "its length is wrong";
  const bool code = record.kind->group == Group::Code;
  if (code && record.bytes.size() < kBody + 2) return "it has no code";
  if (code && wordAt(record.bytes, record.bytes.size() - 2) != kEnd)
    return "it does not end with BE";
  return {};
}

template <typename Rows, typename Field, typename Value>
std::uint8_t codeOf(const Rows& rows, Field field, Value value) {
  for (const auto& row : rows)
    if (row.*field == value) return row.code;
  return 0;
}

std::uint8_t typeCode(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::Input:
    case ParameterKind::Output:
      return codeOf(kWidths, &WidthCode::width, parameter.width);
    case ParameterKind::Data:
      return codeOf(kParameterFormats, &FormatCode::format, parameter.format);
    case ParameterKind::Timer:
    case ParameterKind::Counter:
    case ParameterKind::Block:
      break;
  }
  return 0;
}

void addText(std::vector<std::uint8_t>& out, const std::string& text, std::size_t width,
             Encoding codePage) {
  std::string bytes = source::toDos(text, codePage).substr(0, width);
  bytes.resize(width, ' ');
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void writeHead(const mc5::Block& block, Encoding codePage, std::vector<std::uint8_t>& out) {
  const std::size_t distance = kJumpWords + kParameterWords * block.parameters.size();
  addWord(out, static_cast<std::uint32_t>(kJump | distance));
  addText(out, block.name, kNameBytes, codePage);
  for (const Parameter& parameter : block.parameters) {
    out.push_back(codeOf(kKinds, &KindCode::kind, parameter.kind));
    out.push_back(typeCode(parameter));
    addText(out, parameter.name, kParameterName, codePage);
  }
}

}  // namespace

BlockOrReason readBlock(const Record& record, Encoding codePage) {
  if (record.kind == nullptr || !record.kind->block)
    return {std::nullopt, "SINUMERIK 810/820 has no such block"};
  BlockOrReason result;
  result.reason = damageOf(record);
  if (!result.reason.empty()) return result;
  mc5::Block block;
  const Bytes bytes = record.bytes;
  block.id = {*record.kind->block, record.number};
  block.library =
      static_cast<std::uint32_t>(byteAt(bytes, kLibrary) << 16) | wordAt(bytes, kLibrary + 1);
  std::size_t at = kBody;
  if (block.id.type == mc5::BlockType::Fb) at = readHead(bytes, codePage, block, result.reason);
  if (!result.reason.empty()) return result;
  for (; at + 1 < bytes.size(); at += 2) block.words.push_back(wordAt(bytes, at));
  if (record.kind->group == Group::Data) block.formats.assign(block.words.size(), Format::Hex);
  result.block = std::move(block);
  return result;
}

std::vector<std::uint8_t> writeBlock(const mc5::Block& block, Encoding codePage) {
  const bool data = block.id.type == mc5::BlockType::Db;
  std::vector<std::uint8_t> out(kBody, 0);
  if (block.id.type == mc5::BlockType::Fb) writeHead(block, codePage, out);
  for (const std::uint16_t word : block.words) addWord(out, word);
  putHead(out, *kindOf(block.id.type, data ? Group::Data : Group::Code), block.id.number,
          block.library);
  return out;
}

}  // namespace merker::s5d
