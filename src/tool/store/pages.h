// Areas of bytes in the tables `area` and `page`, 256 bytes a row, so that a cycle writes only what
// it changed.
#pragma once

#include <map>
#include <utility>

#include "store/areas.h"
#include "store/database.h"

namespace merker::store {

constexpr std::size_t kPageBytes = 256;

class Pages {
 public:
  explicit Pages(Database& database);
  // All areas; throws Damage if a page is missing or its checksum is wrong.
  std::map<AreaId, Bytes> read();
  // Brings the area to these bytes. Only pages that differ from what was read or put before.
  void put(const AreaId& id, std::span<const std::uint8_t> bytes);
  void remove(const AreaId& id);
  // Whether areas came, went or changed their length since the last call.
  bool takeChange() { return std::exchange(changed_, false); }
  const std::map<AreaId, Bytes>& known() const { return known_; }

 private:
  Bytes readArea(const AreaId& id, std::int64_t length);
  void putLength(const AreaId& id, std::size_t length);
  void putPage(const AreaId& id, std::size_t page, std::span<const std::uint8_t> bytes);

  Statement selectAreas_, selectPages_, selectCount_, writeArea_, writePage_, cutPages_,
      deleteArea_;
  std::map<AreaId, Bytes> known_;
  bool changed_ = false;
};

}  // namespace merker::store
