#include "s5d/pre_header.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "s5d/bytes.h"
#include "s5d/format_code.h"

namespace merker::s5d {
namespace {

using mc5::Format;

// Section 2.3; a word that another code names (address, C) is a KH.
constexpr std::array kFormats{
    FormatCode{0x01, Format::Binary},  FormatCode{0x02, Format::Hex},
    FormatCode{0x03, Format::Bytes},   FormatCode{0x04, Format::Characters},
    FormatCode{0x05, Format::Fixed},   FormatCode{0x06, Format::Time},
    FormatCode{0x07, Format::Counter}, FormatCode{0x08, Format::Float}};
constexpr std::size_t kRangeBytes = 4, kRangeWords = 2;
constexpr std::size_t kLabelBytes = 6, kLabelWords = 3, kLabelCharacters = 4;

Format formatOf(std::uint8_t code) {
  for (const FormatCode& row : kFormats)
    if (row.code == code) return row.format;
  return Format::Hex;
}

std::uint8_t codeOf(Format format) {
  for (const FormatCode& row : kFormats)
    if (row.format == format) return row.code;
  return 0x02;
}

bool printable(std::uint16_t word) {
  const auto good = [](unsigned c) { return c >= ' ' && c < 0x7F && c != '\''; };
  return good(word >> 8) && good(word & 0xFF);
}

// Characters of several words are one text (KS), if they can be written as one.
void setRange(mc5::Block& block, std::size_t from, std::size_t to, Format format) {
  to = std::min(to, block.words.size());
  if (from >= to) return;
  if (format == Format::Float && (to - from) % 2 != 0) --to;
  std::fill(block.formats.begin() + static_cast<std::ptrdiff_t>(from),
            block.formats.begin() + static_cast<std::ptrdiff_t>(to), format);
  if (format != Format::Characters) return;
  const auto first = block.words.begin();
  const bool text = std::all_of(first + static_cast<std::ptrdiff_t>(from),
                                first + static_cast<std::ptrdiff_t>(to), printable);
  if (text && to - from > 1)
    block.texts[static_cast<std::uint32_t>(from)] = static_cast<std::uint32_t>(to - from);
  else if (!text)
    std::fill(block.formats.begin() + static_cast<std::ptrdiff_t>(from),
              block.formats.begin() + static_cast<std::ptrdiff_t>(to), Format::Hex);
}

// Words from `at` that share one entry: the same format, and one text.
std::size_t endOfRange(const mc5::Block& block, std::size_t at) {
  const auto text = block.texts.find(static_cast<std::uint32_t>(at));
  if (text != block.texts.end()) return at + text->second;
  const Format format = block.formats[at];
  if (format == Format::Characters) return at + 1;
  std::size_t end = at;
  while (end < block.formats.size() && block.formats[end] == format) ++end;
  return end;
}

}  // namespace

bool readFormats(Bytes preHeader, mc5::Block& block) {
  block.formats.assign(block.words.size(), Format::Hex);
  const std::size_t rest = wordAt(preHeader, kPreRest);
  if (rest < kRangeWords || kPreEntries + 2 * rest > preHeader.size()) return false;
  const std::size_t ranges = (rest - 2) / kRangeWords;
  std::size_t before = 0;
  for (std::size_t i = 0; i < ranges; ++i) {
    const std::size_t entry = kPreEntries + i * kRangeBytes;
    const std::size_t from = wordAt(preHeader, entry + 2);
    const std::size_t to = wordAt(preHeader, entry + kRangeBytes + 2);
    if (from < before || to < from) return false;
    setRange(block, from, to, formatOf(byteAt(preHeader, entry + 1)));
    before = from;
  }
  return true;
}

std::vector<std::uint8_t> writeFormats(const mc5::Block& block) {
  std::vector<std::uint8_t> out(kPreEntries, 0);
  std::size_t ranges = 0;
  for (std::size_t at = 0; at < block.formats.size(); at = endOfRange(block, at)) {
    addWord(out, codeOf(block.formats[at]));
    addWord(out, static_cast<std::uint32_t>(at));
    ++ranges;
  }
  addWord(out, 0);
  addWord(out, static_cast<std::uint32_t>(block.words.size()));
  setWord(out, kPreRest, static_cast<std::uint32_t>(ranges * kRangeWords + 2));
  putHead(out, *kindOf(mc5::BlockType::Db, Group::Formats), block.id.number, 0);
  return out;
}

void readLabels(Bytes preHeader, mc5::Block& block) {
  const std::size_t rest = wordAt(preHeader, kPreRest);
  const bool mine = rest % kLabelWords == 0 && kPreEntries + 2 * rest == preHeader.size();
  if (!mine) return;
  std::map<std::uint32_t, std::string> labels;
  for (std::size_t at = kPreEntries; at < preHeader.size(); at += kLabelBytes) {
    std::string name;
    for (std::size_t i = 0; i < kLabelCharacters; ++i)
      name += static_cast<char>(preHeader[at + 2 + i]);
    name.erase(name.find_last_not_of(' ') + 1);
    const bool good = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
                      std::ranges::all_of(name, [](unsigned char c) {
                        return c < 0x80 && (std::isupper(c) != 0 || std::isdigit(c) != 0 ||
                                            c == '-' || c == '/' || c == '_');
                      });
    const std::uint32_t word = wordAt(preHeader, at);
    if (!good || word >= block.words.size() || !labels.emplace(word, name).second) return;
  }
  block.labels = std::move(labels);
}

std::vector<std::uint8_t> writeLabels(const mc5::Block& block) {
  if (block.labels.empty()) return {};
  std::vector<std::uint8_t> out(kPreEntries, 0);
  for (const auto& [word, name] : block.labels) {
    addWord(out, word);
    std::string text = name.substr(0, kLabelCharacters);
    text.resize(kLabelCharacters, ' ');
    out.insert(out.end(), text.begin(), text.end());
  }
  setWord(out, kPreRest, static_cast<std::uint32_t>(block.labels.size() * kLabelWords));
  putHead(out, *kindOf(mc5::BlockType::Fb, Group::Labels), block.id.number, 0);
  return out;
}

}  // namespace merker::s5d
