// Values that one browser modifies at a point of the cycle: once, or each time (S7-MGR-16).
#pragma once

#include <vector>

#include "monitor/monitor.h"

namespace merker::workbench {

class ModifyList {
 public:
  // The problem of the first wish that cannot be carried out.
  static Result<ModifyList> of(monitor::Monitor& monitor, const std::vector<monitor::Wish>& wishes,
                               monitor::Trigger trigger);
  // The CPU has come to this point.
  void reached(monitor::Monitor& monitor, monitor::CyclePoint point);
  // True one time after a trigger that counts once.
  bool takeDone();
  std::size_t size() const { return rows_.size(); }

 private:
  std::vector<monitor::Change> rows_;
  monitor::Trigger trigger_;
  bool done_ = false, told_ = false;
};

}  // namespace merker::workbench
