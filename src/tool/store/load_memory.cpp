#include "store/load_memory.h"

#include <algorithm>
#include <array>
#include <map>

#include "block/container.h"
#include "store/checksum.h"

namespace merker::store {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A container does not know READ_ONLY (docs/formats/block.md), so it stands beside.
struct Stored {
  Bytes container;
  bool readOnly = false;
  bool operator==(const Stored&) const = default;
};
using Blocks = std::map<BlockId, Stored>;

void checkSum(const Bytes& bytes, std::int64_t sum, const std::string& what) {
  if (crc32(bytes) != static_cast<std::uint64_t>(sum))
    throw Damage("the checksum of " + what + " is wrong");
}

BlockId blockOf(std::int64_t kind, std::int64_t number) {
  static constexpr std::array kKinds{BlockKind::OB,  BlockKind::DB, BlockKind::SDB, BlockKind::FC,
                                     BlockKind::SFC, BlockKind::FB, BlockKind::SFB};
  const auto found = std::find_if(kKinds.begin(), kKinds.end(), [kind](BlockKind known) {
    return static_cast<std::int64_t>(known) == kind;
  });
  if (found == kKinds.end() || number < 0 || number > 0xFFFF)
    throw Damage("the list of blocks is wrong");
  return {*found, static_cast<std::uint16_t>(number)};
}

bool flag(std::int64_t value) {
  if (value != 0 && value != 1) throw Damage("the list of blocks is wrong");
  return value == 1;
}

Blocks readBlocks(Database& database) {
  Blocks blocks;
  Statement select =
      database.prepare("SELECT kind, number, read_only, container, checksum FROM block");
  while (select.step()) {
    const BlockId id = blockOf(select.integer(0), select.integer(1));
    Stored stored{select.bytes(3), flag(select.integer(2))};
    checkSum(stored.container, select.integer(4), toString(id));
    blocks[id] = std::move(stored);
  }
  return blocks;
}

Blocks toBlocks(const block::Program& program) {
  Blocks blocks;
  for (const auto& [id, source] : program)
    if (hasContainer(source))
      blocks[id] = {block::writeContainer(source), source.attributes.readOnly};
  return blocks;
}

void writeBlock(Database& database, BlockId id, const Stored& stored) {
  database.prepare("INSERT OR REPLACE INTO block VALUES (?, ?, ?, ?, ?)")
      .bind(static_cast<std::int64_t>(id.kind))
      .bind(std::int64_t{id.number})
      .bind(std::int64_t{stored.readOnly})
      .bind(stored.container)
      .bind(std::int64_t{crc32(stored.container)})
      .run();
}

void deleteBlock(Database& database, BlockId id) {
  database.prepare("DELETE FROM block WHERE kind = ? AND number = ?")
      .bind(static_cast<std::int64_t>(id.kind))
      .bind(std::int64_t{id.number})
      .run();
}

block::Block toBlock(BlockId id, const Stored& stored) {
  auto read = block::readContainer(stored.container, {});
  if (!read || read->id != id) throw Damage(toString(id) + " is not a block");
  read->attributes.readOnly = stored.readOnly;
  return std::move(*read);
}

}  // namespace

bool hasContainer(const block::Block& block) { return block.id.kind != BlockKind::UDT; }

std::string readSetting(Database& database, std::string_view name) {
  Statement select = database.prepare("SELECT value, checksum FROM setting WHERE name = ?");
  select.bind(name);
  if (!select.step()) return {};
  const Bytes value = select.bytes(0);
  checkSum(value, select.integer(1), std::string(name));
  return {value.begin(), value.end()};
}

void writeSetting(Database& database, std::string_view name, const std::string& text) {
  const Bytes value(text.begin(), text.end());
  database.prepare("INSERT OR REPLACE INTO setting VALUES (?, ?, ?)")
      .bind(name)
      .bind(value)
      .bind(std::int64_t{crc32(value)})
      .run();
}

LoadMemory readLoadMemory(Database& database) {
  if (database.integer("SELECT count(*) FROM setting"
                       " WHERE name NOT IN ('cpu', 'configuration', 'contents')"))
    throw Damage("it contains an unknown setting");
  LoadMemory memory{readSetting(database, "cpu"), readSetting(database, "configuration"), {}};
  for (const auto& [id, stored] : readBlocks(database))
    memory.program.emplace(id, toBlock(id, stored));
  return memory;
}

Download writeLoadMemory(Database& database, const LoadMemory& wanted) {
  Download download;
  download.anotherCpu = readSetting(database, "cpu") != wanted.cpu;
  download.anotherConfiguration = readSetting(database, "configuration") != wanted.configuration;
  if (download.anotherCpu) writeSetting(database, "cpu", wanted.cpu);
  if (download.anotherConfiguration) writeSetting(database, "configuration", wanted.configuration);
  const Blocks there = readBlocks(database), blocks = toBlocks(wanted.program);
  for (const auto& [id, stored] : blocks) {
    const auto old = there.find(id);
    if (old != there.end() && old->second == stored) continue;
    writeBlock(database, id, stored);
    download.loaded.push_back(id);
  }
  for (const auto& [id, stored] : there) {
    if (blocks.contains(id)) continue;
    deleteBlock(database, id);
    download.deleted.push_back(id);
  }
  return download;
}

}  // namespace merker::store
