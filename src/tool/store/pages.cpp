#include "store/pages.h"

#include <fmt/format.h>

#include <algorithm>

#include "store/checksum.h"

namespace merker::store {
namespace {

// No area of a CPU is longer than a data block.
constexpr std::int64_t kLongestArea = 1 << 20;

std::size_t pagesOf(std::size_t length) { return (length + kPageBytes - 1) / kPageBytes; }

}  // namespace

Pages::Pages(Database& database)
    : selectAreas_(database.prepare("SELECT kind, number, length FROM area")),
      selectPages_(database.prepare("SELECT page, bytes, checksum FROM page"
                                    " WHERE kind = ? AND number = ? ORDER BY page")),
      selectCount_(database.prepare("SELECT count(*) FROM page")),
      writeArea_(database.prepare("INSERT OR REPLACE INTO area VALUES (?, ?, ?)")),
      writePage_(database.prepare("INSERT OR REPLACE INTO page VALUES (?, ?, ?, ?, ?)")),
      cutPages_(database.prepare("DELETE FROM page WHERE kind = ? AND number = ? AND page >= ?")),
      deleteArea_(database.prepare("DELETE FROM area WHERE kind = ? AND number = ?")) {}

Bytes Pages::readArea(const AreaId& id, std::int64_t length) {
  Bytes all;
  std::int64_t next = 0;
  selectPages_.bind(id.kind).bind(std::int64_t{id.number});
  while (selectPages_.step()) {
    const Bytes page = selectPages_.bytes(1);
    if (page.size() > kPageBytes)
      throw Damage(fmt::format("a page of area {} {} is too long", id.kind, id.number));
    if (selectPages_.integer(0) != next++)
      throw Damage(fmt::format("a page of area {} {} is missing", id.kind, id.number));
    if (crc32(page) != static_cast<std::uint64_t>(selectPages_.integer(2)))
      throw Damage(fmt::format("the checksum of area {} {} is wrong", id.kind, id.number));
    all.insert(all.end(), page.begin(), page.end());
    if (static_cast<std::int64_t>(all.size()) > length) break;
  }
  if (static_cast<std::int64_t>(all.size()) != length)
    throw Damage(fmt::format("area {} {} has a wrong length", id.kind, id.number));
  return all;
}

std::map<AreaId, Bytes> Pages::read() {
  std::vector<std::pair<AreaId, std::int64_t>> found;
  while (selectAreas_.step()) {
    const std::int64_t number = selectAreas_.integer(1), length = selectAreas_.integer(2);
    if (number < 0 || number > 0xFFFF || length < 0 || length > kLongestArea)
      throw Damage("the list of areas is wrong");
    found.push_back({{selectAreas_.text(0), static_cast<std::uint16_t>(number)}, length});
  }
  known_.clear();
  for (const auto& [id, length] : found) known_[id] = readArea(id, length);
  std::size_t pages = 0;
  for (const auto& [id, bytes] : known_) pages += pagesOf(bytes.size());
  if (selectCount_.step() && selectCount_.integer(0) != static_cast<std::int64_t>(pages))
    throw Damage("there are pages without an area");
  selectCount_.run();
  return known_;
}

void Pages::putLength(const AreaId& id, std::size_t length) {
  changed_ = true;
  writeArea_.bind(id.kind).bind(std::int64_t{id.number});
  writeArea_.bind(static_cast<std::int64_t>(length)).run();
  const std::size_t pages = pagesOf(length);
  cutPages_.bind(id.kind).bind(std::int64_t{id.number});
  cutPages_.bind(static_cast<std::int64_t>(pages)).run();
}

void Pages::putPage(const AreaId& id, std::size_t page, std::span<const std::uint8_t> bytes) {
  writePage_.bind(id.kind).bind(std::int64_t{id.number}).bind(static_cast<std::int64_t>(page));
  writePage_.bind(bytes).bind(std::int64_t{crc32(bytes)}).run();
}

void Pages::put(const AreaId& id, std::span<const std::uint8_t> bytes) {
  const auto [entry, isNew] = known_.try_emplace(id);
  Bytes& old = entry->second;
  if (!isNew && std::equal(old.begin(), old.end(), bytes.begin(), bytes.end())) return;
  if (isNew || old.size() != bytes.size()) putLength(id, bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += kPageBytes) {
    const auto page = bytes.subspan(at, std::min(kPageBytes, bytes.size() - at));
    const auto before = std::span(old).subspan(
        std::min(at, old.size()), std::min(kPageBytes, old.size() - std::min(at, old.size())));
    if (!std::equal(page.begin(), page.end(), before.begin(), before.end()))
      putPage(id, at / kPageBytes, page);
  }
  old.assign(bytes.begin(), bytes.end());
}

void Pages::remove(const AreaId& id) {
  cutPages_.bind(id.kind).bind(std::int64_t{id.number}).bind(std::int64_t{0}).run();
  deleteArea_.bind(id.kind).bind(std::int64_t{id.number}).run();
  changed_ = known_.erase(id) > 0 || changed_;
}

}  // namespace merker::store
