#include "store/contents.h"

#include <fmt/format.h>

#include "base/bytes.h"
#include "store/checksum.h"

namespace merker::store {
namespace {

constexpr std::string_view kName = "contents";

void append(Bytes& list, std::string_view text) {
  appendDWord(list, static_cast<std::uint32_t>(text.size()));
  list.insert(list.end(), text.begin(), text.end());
}

void append(Bytes& list, std::int64_t number) {
  appendDWord(list, static_cast<std::uint32_t>(number));
}

std::uint32_t sumOfLoadMemory(Database& database) {
  Bytes list;
  Statement settings =
      database.prepare("SELECT name, checksum FROM setting WHERE name <> 'contents' ORDER BY name");
  while (settings.step()) {
    append(list, settings.text(0));
    append(list, settings.integer(1));
  }
  Statement blocks =
      database.prepare("SELECT kind, number, read_only, checksum FROM block ORDER BY kind, number");
  constexpr int kColumns = 4;
  while (blocks.step())
    for (int column = 0; column < kColumns; ++column) append(list, blocks.integer(column));
  return crc32(list);
}

std::uint32_t sumOfAreas(const Contents::Areas& areas) {
  Bytes list;
  for (const auto& [id, bytes] : areas) {
    append(list, id.kind);
    append(list, std::int64_t{id.number});
    append(list, static_cast<std::int64_t>(bytes.size()));
  }
  return crc32(list);
}

void requireCpu(const LoadMemory& load, const Contents::Areas& areas) {
  if (load.cpu.empty() && !(load.program.empty() && load.configuration.empty() && areas.empty()))
    throw Damage("the CPU model is missing");
}

void requireAreas(const Contents::Areas& areas) {
  if (areas.empty()) return;  // loaded, but never switched on
  for (const AreaId& id : areasOfEachCard())
    if (!areas.contains(id)) throw Damage(fmt::format("the area '{}' is missing", id.kind));
}

// Format 1 has no sum. What it does not tell from damage is refused: a data block that the CPU had
// deleted, or that was loaded a moment before the process ended.
void requireDataBlocks(const LoadMemory& load, const Contents::Areas& areas) {
  if (areas.empty()) return;
  for (const auto& [id, block] : load.program) {
    if (id.kind != BlockKind::DB || block.attributes.nonRetain || block.attributes.unlinked)
      continue;
    if (areas.contains({"made DB", id.number})) continue;
    const Bytes& data = block.actualData.empty() ? block.initialData : block.actualData;
    const auto kept = areas.find({"DB", id.number});
    if (kept == areas.end() || kept->second.size() != data.size())
      throw Damage(fmt::format("the actual values of {} are missing", toString(id)));
  }
}

}  // namespace

Contents::Contents(Database& database, std::int64_t format)
    : database_(database), format_(format), loadSum_(sumOfLoadMemory(database)) {}

std::string Contents::sum(const Areas& areas) const {
  Bytes sums;
  appendDWord(sums, loadSum_);
  appendDWord(sums, sumOfAreas(areas));
  return {sums.begin(), sums.end()};
}

void Contents::require(const LoadMemory& load, const Areas& areas) const {
  requireCpu(load, areas);
  requireAreas(areas);
  if (old()) requireDataBlocks(load, areas);
  const std::string written = readSetting(database_, kName);
  const bool none = old() || (load.cpu.empty() && load.program.empty() && areas.empty());
  if (written != (none ? std::string() : sum(areas)))
    throw Damage("settings, blocks and areas in it do not belong together");
}

void Contents::loadMemoryChanged() { loadSum_ = sumOfLoadMemory(database_); }

void Contents::write(const Areas& areas) {
  writeSetting(database_, kName, sum(areas));
  if (old()) database_.execute(fmt::format("PRAGMA user_version = {}", kFormat).c_str());
  format_ = kFormat;
}

}  // namespace merker::store
