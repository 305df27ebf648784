// What belongs together on a card: rows that are missing or exchanged leave a database in order,
// and every row right by itself. So each transaction that changes the lists of settings, blocks or
// areas also writes a sum of these lists, as the setting `contents` (docs/formats/card.md).
#pragma once

#include "store/areas.h"
#include "store/card_file.h"
#include "store/load_memory.h"

namespace merker::store {

class Contents {
 public:
  using Areas = std::map<AreaId, Bytes>;
  Contents(Database& database, std::int64_t format);

  // Throws Damage if something is missing or too much.
  void require(const LoadMemory& load, const Areas& areas) const;
  // A card of an older format has no sum before it is written.
  bool old() const { return format_ < kFormat; }
  void loadMemoryChanged();
  // Inside the transaction that has changed something.
  void write(const Areas& areas);

 private:
  std::string sum(const Areas& areas) const;
  Database& database_;
  std::int64_t format_;
  std::uint32_t loadSum_;  // of settings and blocks
};

}  // namespace merker::store
