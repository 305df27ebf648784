// Program status as one browser sees it (S7-EDIT-21).
#pragma once

#include "monitor/monitor.h"
#include "workbench/json.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

class StatusView {
 public:
  explicit StatusView(monitor::StatusWish wish) : wish_(wish) {}

  // The event "status"; null if there is nothing new.
  Json changes(monitor::Monitor& monitor, const ProjectFolder& folder, std::int64_t nowMs);

 private:
  monitor::StatusWish wish_;
  std::uint64_t calls_ = 0;
  std::int64_t since_ = 0;  // when it was called last, on the wall
  Instant at_{};            // time of the CPU when it was looked at last
  Json told_;               // last; null: nothing yet
};

}  // namespace merker::workbench
