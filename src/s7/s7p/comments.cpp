#include "s7p/comments.h"

#include <algorithm>

namespace merker::s7p {
namespace {

constexpr std::uint8_t kOwnLine = 0x00, kMovesOnly = 0x20;
constexpr std::size_t kBlockHead = 3, kNetworkHead = 6, kRecordHead = 6;

std::uint16_t word(Bytes bytes, std::size_t at) {
  return at + 2 <= bytes.size() ? static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8) : 0;
}

// From `begin` to `end`, or to a NUL before it.
std::string text(Bytes bytes, std::size_t begin, std::size_t end, const CodePage& page) {
  end = std::min(end, bytes.size());
  if (begin >= end) return {};
  std::string_view raw(reinterpret_cast<const char*>(bytes.data()) + begin, end - begin);
  raw = raw.substr(0, raw.find('\0'));
  return page.toUtf8(raw);
}

// Records of a length, lines to go on, flags, column, and the text.
std::vector<StatementComment> statements(Bytes bytes, const CodePage& page) {
  std::vector<StatementComment> list;
  std::uint32_t line = 0;
  for (std::size_t at = 0; at + kRecordHead <= bytes.size();) {
    const std::size_t length = word(bytes, at);
    const std::uint8_t flags = bytes[at + 4];
    line += word(bytes, at + 2);
    const std::size_t begin = at + kRecordHead;
    if (begin + length > bytes.size()) break;
    if (flags != kMovesOnly && length > 0)
      list.push_back({line, flags == kOwnLine, text(bytes, begin, begin + length, page)});
    at = begin + length;
  }
  return list;
}

NetworkComments network(Bytes bytes, const CodePage& page) {
  NetworkComments result;
  if (bytes.size() < kNetworkHead) return result;
  const std::size_t comment = word(bytes, 1), end = word(bytes, 3);
  result.title = text(bytes, kNetworkHead, comment, page);
  result.comment = text(bytes, comment, end, page);
  if (end >= kNetworkHead && end <= bytes.size())
    result.statements = statements(bytes.subspan(end), page);
  return result;
}

}  // namespace

BlockComments readComments(Bytes block, Bytes lengths, Bytes networks, const CodePage& page) {
  BlockComments result;
  if (block.size() >= kBlockHead) {
    const std::size_t comment = word(block, 1);
    result.title = text(block, kBlockHead, comment, page);
    result.comment = text(block, std::max(comment, kBlockHead), block.size(), page);
  }
  const std::size_t count = word(lengths, 0);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count && 4 + 2 * i <= lengths.size(); ++i) {
    const std::size_t length = word(lengths, 2 + 2 * i);
    if (at + length > networks.size()) break;
    result.networks.push_back(network(networks.subspan(at, length), page));
    at += length;
  }
  return result;
}

}  // namespace merker::s7p
