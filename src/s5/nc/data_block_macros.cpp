#include "nc/data_block_macros.h"

#include <algorithm>
#include <vector>

#include "nc/plc_memory.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;

constexpr unsigned kHighestBlock = 255, kHighestWord = 255, kMostWords = 128;

enum CreateError : std::uint16_t {
  kBlockNumber = 2,
  kBelowZero,
  kOtherLength,
  kNoMemory,
  kWordNumber,
  kBlockZero
};
enum TransferError : std::uint16_t {
  kTooMany = 1,
  kNone,
  kNoSource,
  kNoTarget,
  kTargetShort,
  kTargetInEprom,
  kSourceShort
};

// A block that is there with this length stays as it is (S5-FM-11).
Error createBlock(Machine& m, std::uint16_t number, std::uint32_t words) {
  if (number == 0) return kBlockZero;
  if (hasDataBlock(m, number)) {
    if (dataBlock(m, number).size() == words) return std::nullopt;
    return kOtherLength;
  }
  if (!m.blocks.createData(number, words)) return kNoMemory;
  return std::nullopt;
}

Error createRow(Machine& m, std::uint16_t first, unsigned count, std::int16_t lastWord) {
  if (first + count - 1 > kHighestBlock) return kBlockNumber;
  if (lastWord < 0) return kBelowZero;
  if (lastWord > static_cast<int>(kHighestWord)) return kWordNumber;
  for (unsigned i = 0; i < count; ++i)
    if (const Error error = createBlock(m, static_cast<std::uint16_t>(first + i), lastWord + 1u))
      return error;
  return std::nullopt;
}

struct Transfer {
  std::uint8_t source = 0, target = 0;
  std::uint16_t from = 0;
  std::uint8_t to = 0, count = 0;
};

// One of the blocks 0: the transfer flags say it all (S5-FM-21).
Transfer transferOf(const Machine& m, Parameters p) {
  std::uint16_t blocks = p[0], from = p[1], rest = p[2];
  if (highByte(blocks) == 0 || lowByte(blocks) == 0) {
    blocks = flagWord(m, 250);
    from = flagWord(m, 252);
    rest = flagWord(m, 254);
  }
  return {highByte(blocks), lowByte(blocks), from, highByte(rest), lowByte(rest)};
}

Error check(Machine& m, const Transfer& t) {
  if (t.count > kMostWords) return kTooMany;
  if (t.count == 0) return kNone;
  if (!hasDataBlock(m, t.source)) return kNoSource;
  if (!hasDataBlock(m, t.target)) return kNoTarget;
  if (t.to + t.count > static_cast<int>(dataBlock(m, t.target).size())) return kTargetShort;
  if (m.dataInEprom.test(t.target)) return kTargetInEprom;
  if (std::size_t{t.from} + t.count > dataBlock(m, t.source).size()) return kSourceShort;
  return std::nullopt;
}

}  // namespace

// The count 0 takes both parameters from the transfer flags; there it counts as 1, the least.
Error createDataBlocks(Machine& m, Parameters p) {
  std::uint16_t blocks = p[0], lastWord = p[1];
  if (lowByte(blocks) == 0) {
    blocks = flagWord(m, 246);
    lastWord = flagWord(m, 248);
  }
  const unsigned count = std::max<unsigned>(lowByte(blocks), 1);
  return createRow(m, highByte(blocks), count, static_cast<std::int16_t>(lastWord));
}

Error transferBlock(Machine& m, Parameters p) {
  const Transfer t = transferOf(m, p);
  if (const Error error = check(m, t)) return error;
  const auto source = dataBlock(m, t.source).subspan(t.from, t.count);
  const std::vector<std::uint16_t> words(source.begin(), source.end());  // blocks may overlap
  std::copy(words.begin(), words.end(), dataBlock(m, t.target).begin() + t.to);
  return std::nullopt;
}

}  // namespace merker::nc
