// What all browsers share, and what each has of its own.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "workbench/pace.h"
#include "workbench/plc.h"
#include "workbench/watch_list.h"

namespace merker::workbench {

constexpr std::size_t kLists = 64, kItems = 1000;  // of each browser, of each list

struct Shared {
  std::unique_ptr<Plc> plc;  // null: no project is open
  bool example = false;      // it is a copy of one
  Pacer pacer;
  std::uint64_t programRevision = 1, filesRevision = 1;
};

struct Browser {
  Json state = Json::object();  // what it knows of it
  std::map<std::int64_t, WatchList> lists;
};

// All of the event "state".
Json state(Shared& shared);
// What differs; null stands for a field that is now null.
Json difference(const Json& before, const Json& now);

}  // namespace merker::workbench
