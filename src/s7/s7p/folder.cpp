#include "s7p/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "base/bytes.h"
#include "block/container.h"
#include "block/interface_part.h"
#include "block/segment_table.h"
#include "s7p/catalogue.h"

namespace merker::s7p {
namespace {

constexpr std::uint32_t kLinked = 1, kProtected = 3, kUdt = 1, kVariableTable = 27;
constexpr std::size_t kLargestPart = 4u << 20, kMostRows = 200'000, kStamp = 6;

// SUBBLKTYP of the parts of a block: itself, the text of its declaration, its comments.
struct Parts {
  BlockKind kind;
  std::uint32_t code, text, comments;
};
constexpr std::array<Parts, 7> kParts{{{BlockKind::OB, 8, 3, 17},
                                       {BlockKind::FC, 12, 5, 19},
                                       {BlockKind::FB, 14, 4, 18},
                                       {BlockKind::SFC, 13, 7, 22},
                                       {BlockKind::SFB, 15, 9, 21},
                                       {BlockKind::DB, 10, 6, 20},
                                       {BlockKind::UDT, kUdt, kUdt, 39}}};

const Parts* partsOf(std::uint32_t type) {
  for (const Parts& parts : kParts)
    if (parts.code == type) return &parts;
  return nullptr;
}

const Parts& partsOf(BlockKind kind) {
  return *std::find_if(kParts.begin(), kParts.end(),
                       [kind](const Parts& parts) { return parts.kind == kind; });
}

// u32 milliseconds of the day, u16 days since 1984-01-01; big-endian.
std::string stampText(std::string_view raw) {
  if (raw.size() < kStamp) return {};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(raw.data());
  using namespace std::chrono;
  const auto date = year_month_day(sys_days(year(1984) / 1 / 1) + days(loadWord(bytes + 4)));
  const std::uint32_t ms = loadDWord(bytes);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}.{:03}", int(date.year()),
                     unsigned(date.month()), unsigned(date.day()), ms / 3'600'000 % 24,
                     ms / 60'000 % 60, ms / 1000 % 60, ms % 1000);
}

}  // namespace

Folder::Folder(const archive::Tree& tree, const std::string& folder, const CodePage& page,
               Faults& faults)
    : folder_(folder), page_(page), faults_(faults) {
  Table table = openTable(tree, under(folder, "SUBBLK.DBF"), faults);
  const std::string memo = under(folder, "subblk.dbt");
  if (tree.find(memo) != nullptr) memo_ = Memo(tree.open(memo));
  while (table.next()) {
    if (rows_.size() == kMostRows) {
      faults.push_back(
          {FaultKind::LongTable, under(folder, "SUBBLK.DBF"), std::to_string(kMostRows)});
      break;
    }
    add(table);
  }
  if (!rows_.empty() && !memo_.good())
    faults.push_back({FaultKind::NoMemo, under(folder, "SUBBLK.DBT"), {}});
  std::stable_sort(rows_.begin(), rows_.end(),
                   [](const Row& a, const Row& b) { return a.object < b.object; });
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (const Parts* parts = partsOf(rows_[i].type))
      places_.emplace_back(BlockId{parts->kind, rows_[i].number}, i);
  // Linked ones first, then the older row.
  std::stable_sort(places_.begin(), places_.end(), [this](const auto& a, const auto& b) {
    const bool linkedA = (rows_[a.second].attribute & kLinked) != 0;
    const bool linkedB = (rows_[b.second].attribute & kLinked) != 0;
    return a.first != b.first ? a.first < b.first : linkedA && !linkedB;
  });
  for (const auto& [id, place] : places_) {
    if (ids_.empty() || ids_.back() != id)
      ids_.push_back(id);
    else
      faults.push_back({FaultKind::TwiceInFolder, folder_, toString(id)});
  }
}

void Folder::add(Table& table) {
  Row row;
  const auto number = table.number("BLKNUMBER");
  const auto type = table.number("SUBBLKTYP");
  if (!number || !type || *number > 0xFFFF) {
    faults_.push_back({FaultKind::WrongNumber, folder_, page_.toUtf8(table.text("BLKNUMBER"))});
    return;
  }
  row.number = static_cast<std::uint16_t>(*number);
  row.type = *type;
  row.object = table.numberOr("OBJECTID", 0);
  row.language = table.numberOr("BLKLANG", 1);
  row.attribute = table.numberOr("ATTRIBUTE", 0);
  row.reserved = table.numberOr("AGRESERVED", 1);
  row.password = table.numberOr("PASSWORD", 0);
  row.local = table.numberOr("LOCDATALEN", 0);
  row.checksum = table.numberOr("CHECKSUM", 0);
  row.version = static_cast<std::uint8_t>(table.numberOr("VERSION", 0));
  row.code = table.numberOr("MC5CODE", 0);
  row.codeLength = table.numberOr("MC5LEN", 0);
  row.interface = table.numberOr("SSBPART", 0);
  row.interfaceLength = table.numberOr("SSBLEN", 0);
  row.more = table.numberOr("ADDINFO", 0);
  row.moreLength = table.numberOr("ADDLEN", 0);
  row.stamp = table.bytes("TIMESTAMP1");
  row.author = page_.toUtf8(table.text("USERNAME"));
  row.family = page_.toUtf8(table.text("BLOCKFNAME"));
  row.name = page_.toUtf8(table.text("BLOCKNAME"));
  rows_.push_back(std::move(row));
}

// The part of the same block with this type.
const Folder::Row* Folder::beside(const Row& row, std::uint32_t type) const {
  const auto from =
      std::lower_bound(rows_.begin(), rows_.end(), row.object,
                       [](const Row& r, std::uint32_t object) { return r.object < object; });
  for (auto at = from; at != rows_.end() && at->object == row.object; ++at)
    if (at->type == type && at->number == row.number) return &*at;
  return nullptr;
}

std::vector<std::uint8_t> Folder::memo(std::uint32_t block, std::uint32_t length) const {
  if (length == 0) return {};
  return memo_.read(block, std::min<std::size_t>(length, kLargestPart))
      .value_or(std::vector<std::uint8_t>());
}

void Folder::readCode(const Row& row, StoredBlock& result) {
  block::Block& block = result.block;
  const std::string where = toString(block.id);
  std::vector<std::uint8_t> code = memo(row.code, row.codeLength);
  const std::vector<std::uint8_t> interface = memo(row.interface, row.interfaceLength);
  const bool data = block.id.kind == BlockKind::DB;
  if (code.size() != row.codeLength || (code.empty() && !data) || (!data && code.size() % 2 != 0)) {
    if (memo_.good()) faults_.push_back({FaultKind::NoCode, folder_, where});
    result.damaged = true;
    code.clear();
  }
  if (!interface.empty() && !block::readInterface(interface, block)) {
    faults_.push_back({FaultKind::WrongInterface, folder_, where});
    block.variables.clear();
  }
  (data ? block.actualData : block.code) = std::move(code);
  if (!data) block::readSegmentTable(memo(row.more, row.moreLength), block);
  const unsigned computed = block::checksum(block);
  const auto swapped = (computed & 0xFF) << 8 | computed >> 8;
  if (!result.damaged && row.checksum != 0 && row.checksum != swapped)
    faults_.push_back({FaultKind::WrongChecksum, folder_, where});
}

void Folder::readTexts(const Row& row, StoredBlock& result) const {
  const Parts& parts = partsOf(result.block.id.kind);
  if (const Row* text = beside(row, parts.text)) {
    const auto bytes = memo(text->code, text->codeLength);
    std::string raw(bytes.begin(), bytes.end());
    raw.resize(std::min(raw.find('\0'), raw.size()));
    result.declaration = page_.toUtf8(raw);
  }
  if (const Row* comments = beside(row, parts.comments))
    result.comments = readComments(memo(comments->interface, comments->interfaceLength),
                                   memo(comments->more, comments->moreLength),
                                   memo(comments->code, comments->codeLength), page_);
}

std::optional<StoredBlock> Folder::read(BlockId id) {
  const auto at = std::find_if(places_.begin(), places_.end(),
                               [id](const auto& place) { return place.first == id; });
  if (at == places_.end()) return std::nullopt;
  const Row& row = rows_[at->second];
  StoredBlock result;
  block::Block& block = result.block;
  block.id = id;
  block.language = static_cast<block::Language>(row.language);
  block.localBytes = row.local;
  block.attributes.author = row.author;
  block.attributes.family = row.family;
  block.attributes.name = row.name;
  block.attributes.version = row.version;
  block.attributes.unlinked = (row.attribute & kLinked) == 0;
  block.attributes.knowHowProtect = row.password == kProtected;
  block.attributes.codeVersion1 =
      (id.kind == BlockKind::FB || id.kind == BlockKind::FC) && row.reserved == 0;
  result.created = stampText(row.stamp);
  if (id.kind != BlockKind::UDT) readCode(row, result);
  readTexts(row, result);
  block.attributes.title = result.comments.title;
  block.attributes.comment = result.comments.comment;
  return result;
}

std::vector<VariableTable> Folder::variableTables() const {
  std::vector<VariableTable> tables;
  for (const Row& row : rows_)
    if (row.type == kVariableTable)
      tables.push_back(readVariableTable(row.number, memo(row.code, row.codeLength)));
  return tables;
}

}  // namespace merker::s7p
