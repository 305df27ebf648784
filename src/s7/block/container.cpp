#include "block/container.h"

#include <algorithm>
#include <array>

#include "base/bytes.h"
#include "base/text.h"
#include "block/interface_part.h"
#include "block/segment_table.h"

namespace merker::block {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kHeader = 36, kTrailer = 36, kName = 8;
constexpr std::uint8_t kMark = 0x70, kVersion = 0x01;
constexpr std::size_t kLongestPart = 0xFFFF;
constexpr std::uint32_t kProtected = 3;  // security word of a know-how protected block

// Attribute bits at offset 3.
constexpr std::uint8_t kLinked = 0x01, kKnowHow = 0x08, kNotRetentive = 0x20;

// Places in the header.
enum Offset : std::size_t {
  AttributesAt = 3,
  LanguageAt = 4,
  TypeAt = 5,
  NumberAt = 6,
  LengthAt = 8,
  SecurityAt = 12,
  ChangedAt = 16,
  InterfaceLengthAt = 28,
  SegmentLengthAt = 30,
  LocalLengthAt = 32,
  CodeLengthAt = 34
};
// Places in the trailer.
enum TrailerOffset : std::size_t {
  AuthorAt = 0,
  FamilyAt = 8,
  NameAt = 16,
  VersionAt = 24,
  ChecksumAt = 26
};

constexpr std::uint16_t kPolynomial = 0x9003;

std::uint16_t crc(std::uint16_t sum, std::uint8_t byte) {
  sum = static_cast<std::uint16_t>(sum ^ byte << 8);
  for (int bit = 0; bit < 8; ++bit)
    sum = static_cast<std::uint16_t>((sum & 0x8000) != 0 ? sum << 1 ^ kPolynomial : sum << 1);
  return sum;
}

bool holdsData(BlockKind kind) { return kind == BlockKind::DB || kind == BlockKind::SDB; }

const Bytes& content(const Block& block) {
  return holdsData(block.id.kind) ? block.actualData : block.code;
}

std::uint8_t attributeByte(const Attributes& attributes) {
  return static_cast<std::uint8_t>((attributes.unlinked ? 0 : kLinked) |
                                   (attributes.knowHowProtect ? kKnowHow : 0) |
                                   (attributes.nonRetain ? kNotRetentive : 0));
}

void storeName(std::uint8_t* to, const std::string& utf8) {
  const std::string name = toCp1252(utf8);
  std::copy_n(name.begin(), std::min(name.size(), kName), to);
}

std::string loadName(const std::uint8_t* from) {
  const std::string bytes(from, std::find(from, from + kName, 0));
  return toUtf8(bytes, Encoding::Cp1252);
}

void writeHeader(const Block& block, std::size_t interfaceBytes, std::size_t segmentBytes,
                 Bytes& out) {
  out[0] = out[1] = kMark;
  out[2] = kVersion;
  out[AttributesAt] = attributeByte(block.attributes);
  out[LanguageAt] = static_cast<std::uint8_t>(block.language);
  out[TypeAt] = static_cast<std::uint8_t>(block.id.kind);
  storeWord(&out[NumberAt], block.id.number);
  storeDWord(&out[LengthAt], static_cast<std::uint32_t>(out.size()));
  const std::uint32_t security = block.attributes.security;
  storeDWord(&out[SecurityAt], block.attributes.knowHowProtect ? kProtected : security);
  std::ranges::copy(block.attributes.changed, out.begin() + ChangedAt);
  storeWord(&out[InterfaceLengthAt], static_cast<std::uint32_t>(interfaceBytes));
  storeWord(&out[SegmentLengthAt], static_cast<std::uint32_t>(segmentBytes));
  storeWord(&out[LocalLengthAt], block.localBytes);
  storeWord(&out[CodeLengthAt], static_cast<std::uint32_t>(content(block).size()));
}

void writeTrailer(const Block& block, std::uint8_t* out) {
  storeName(out + AuthorAt, block.attributes.author);
  storeName(out + FamilyAt, block.attributes.family);
  storeName(out + NameAt, block.attributes.name);
  out[VersionAt] = block.attributes.version;
  storeWord(out + ChecksumAt, checksum(block));
}

// The parts behind the header, as its lengths say.
struct Parts {
  std::span<const std::uint8_t> content, interface, segments, trailer;
};

bool isContainer(std::span<const std::uint8_t> bytes) {
  static constexpr std::array kKinds{BlockKind::OB,  BlockKind::DB, BlockKind::SDB, BlockKind::FC,
                                     BlockKind::SFC, BlockKind::FB, BlockKind::SFB};
  return bytes[0] == kMark && bytes[1] == kMark && bytes[2] == kVersion &&
         std::find(kKinds.begin(), kKinds.end(), static_cast<BlockKind>(bytes[TypeAt])) !=
             kKinds.end();
}

Result<Parts> split(std::span<const std::uint8_t> bytes, const Position& at) {
  if (bytes.size() < kHeader + kTrailer || !isContainer(bytes))
    return makeProblem(ProblemCode::P0601, at, "it does not begin with a block header");
  const std::size_t content = loadWord(&bytes[CodeLengthAt]);
  const std::size_t interface = loadWord(&bytes[InterfaceLengthAt]);
  const std::size_t segments = loadWord(&bytes[SegmentLengthAt]);
  const std::size_t length = kHeader + content + interface + segments + kTrailer;
  if (loadDWord(&bytes[LengthAt]) != length)
    return makeProblem(ProblemCode::P0602, at,
                       "the parts do not add up to the length of the block");
  if (length > bytes.size()) return makeProblem(ProblemCode::P0602, at, "the block is cut off");
  if (!holdsData(static_cast<BlockKind>(bytes[TypeAt])) && content % 2 != 0)
    return makeProblem(ProblemCode::P0602, at, "the number of code bytes must be even");
  std::size_t next = kHeader;
  const auto take = [&](std::size_t count) {
    next += count;
    return bytes.subspan(next - count, count);
  };
  Parts parts;
  parts.content = take(content);
  parts.interface = take(interface);
  parts.segments = take(segments);
  parts.trailer = take(kTrailer);
  return parts;
}

void readHeader(std::span<const std::uint8_t> bytes, Block& block) {
  const std::uint8_t attributes = bytes[AttributesAt];
  block.attributes.unlinked = (attributes & kLinked) == 0;
  block.attributes.knowHowProtect =
      (attributes & kKnowHow) != 0 || loadDWord(&bytes[SecurityAt]) == kProtected;
  block.attributes.nonRetain = (attributes & kNotRetentive) != 0;
  block.attributes.security = loadDWord(&bytes[SecurityAt]);
  std::copy_n(bytes.begin() + ChangedAt, block.attributes.changed.size(),
              block.attributes.changed.begin());
  block.language = static_cast<Language>(bytes[LanguageAt]);
  block.id = {static_cast<BlockKind>(bytes[TypeAt]), loadWord(&bytes[NumberAt])};
  block.localBytes = loadWord(&bytes[LocalLengthAt]);
}

void readTrailer(std::span<const std::uint8_t> trailer, Block& block) {
  block.attributes.author = loadName(&trailer[AuthorAt]);
  block.attributes.family = loadName(&trailer[FamilyAt]);
  block.attributes.name = loadName(&trailer[NameAt]);
  block.attributes.version = trailer[VersionAt];
}

// The interface of a DB holds the start values, its content the actual ones.
void fillData(std::span<const std::uint8_t> content, Block& block) {
  block.actualData.assign(content.begin(), content.end());
  if (block.variables.empty()) {
    block.initialData = block.actualData;
    return;
  }
  for (const Variable& variable : block.variables)
    writeInitial(variable, variable.address, block.initialData);
  block.initialData.resize(content.size());
}

}  // namespace

std::uint16_t checksum(const Block& block) {
  const Bytes& bytes = content(block);
  const std::size_t size = bytes.size();
  std::uint16_t sum = crc(0, static_cast<std::uint8_t>(block.id.kind));
  sum = crc(sum, static_cast<std::uint8_t>(size >> 8));
  sum = crc(sum, static_cast<std::uint8_t>(size));
  for (const std::uint8_t byte : bytes) sum = crc(sum, byte);
  return sum;
}

std::vector<std::uint8_t> writeContainer(const Block& block) {
  if (block.id.kind == BlockKind::UDT) return {};
  const Bytes& code = content(block);
  const Bytes interface =
      block.id.kind == BlockKind::SDB ? Bytes{} : writeInterface(block);  // system data have none
  const Bytes segments = holdsData(block.id.kind) ? Bytes{} : writeSegmentTable(block);
  if (std::max({code.size(), interface.size(), segments.size()}) > kLongestPart) return {};
  Bytes out(kHeader);
  for (const Bytes* part : {&code, &interface, &segments})
    out.insert(out.end(), part->begin(), part->end());
  out.resize(out.size() + kTrailer);
  writeHeader(block, interface.size(), segments.size(), out);
  writeTrailer(block, &out[out.size() - kTrailer]);
  return out;
}

Result<Block> readContainer(std::span<const std::uint8_t> bytes, const Position& at) {
  const Result<Parts> parts = split(bytes, at);
  if (!parts) return parts.error();
  Block block;
  readHeader(bytes, block);
  readTrailer(parts->trailer, block);
  if (!parts->interface.empty() && !readInterface(parts->interface, block))
    return makeProblem(ProblemCode::P0604, at, toString(block.id));
  const bool data = holdsData(block.id.kind);
  if (data) {
    fillData(parts->content, block);
  } else {
    block.code.assign(parts->content.begin(), parts->content.end());
    readSegmentTable(parts->segments, block);
  }
  const unsigned stored = loadWord(&parts->trailer[ChecksumAt]), computed = checksum(block);
  const bool without = data && stored == 0;  // as a CPU hands it over
  if (stored != computed && !without)
    return makeProblem(ProblemCode::P0603, at, toString(block.id), fmt::format("{:04X}", stored),
                       fmt::format("{:04X}", computed));
  return block;
}

}  // namespace merker::block
