#include "block/segment_table.h"

#include <algorithm>

namespace merker::block {
namespace {

// The last network ends before the final BE.
constexpr std::uint32_t kBlockEnd = 2;

void appendLittle(std::vector<std::uint8_t>& out, std::size_t value) {
  out.push_back(static_cast<std::uint8_t>(value));
  out.push_back(static_cast<std::uint8_t>(value >> 8));
}

std::vector<std::uint32_t> networkStarts(const Block& block) {
  std::vector<std::uint32_t> starts;
  for (const Network& network : block.networks) starts.push_back(network.offset);
  if (starts.empty()) starts.push_back(0);
  return starts;
}

// Words of the table from `at` on that the count before them announces; empty if they are not
// there.
std::vector<std::uint32_t> readGroup(std::span<const std::uint8_t> bytes, std::size_t& at) {
  const auto word = [&](std::size_t i) -> std::uint32_t { return bytes[i] | bytes[i + 1] << 8u; };
  if (at + 2 > bytes.size()) return {};
  const std::size_t count = word(at);
  at += 2;
  if (at + 2 * count > bytes.size()) return {};
  std::vector<std::uint32_t> group;
  for (std::size_t i = 0; i < count; ++i, at += 2) group.push_back(word(at));
  return group;
}

}  // namespace

std::vector<std::uint8_t> writeSegmentTable(const Block& block) {
  const auto size = static_cast<std::uint32_t>(block.code.size());
  const std::uint32_t end = size - std::min(size, kBlockEnd);
  std::vector<std::uint32_t> starts = networkStarts(block);
  std::vector<std::uint8_t> out;
  appendLittle(out, starts.size());
  starts.push_back(std::max(starts.back(), end));
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) appendLittle(out, starts[i + 1] - starts[i]);
  appendLittle(out, block.jumps.size());
  for (const std::uint32_t jump : block.jumps) appendLittle(out, jump);
  return out;
}

void readSegmentTable(std::span<const std::uint8_t> bytes, Block& block) {
  std::size_t at = 0;
  std::uint32_t offset = 0;
  std::vector<Network> networks;
  for (const std::uint32_t length : readGroup(bytes, at)) {
    networks.push_back({offset, {}});
    offset += length;
  }
  if (offset > block.code.size()) return;
  block.networks = std::move(networks);
  block.jumps = readGroup(bytes, at);
}

}  // namespace merker::block
