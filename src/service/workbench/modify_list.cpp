#include "workbench/modify_list.h"

namespace merker::workbench {

Result<ModifyList> ModifyList::of(monitor::Monitor& monitor,
                                  const std::vector<monitor::Wish>& wishes,
                                  monitor::Trigger trigger) {
  ModifyList list;
  list.trigger_ = trigger;
  for (const monitor::Wish& wish : wishes) {
    auto change = monitor.inCycle(wish);
    if (!change) return change.error();
    list.rows_.push_back(std::move(change.value()));
  }
  return list;
}

// What was forced since stays as it is.
void ModifyList::reached(monitor::Monitor& monitor, monitor::CyclePoint point) {
  if (point != trigger_.point || done_) return;
  for (const auto& [reference, value] : rows_)
    if (!monitor.checkWrite(reference)) monitor.modifyInCycle(reference, value);
  done_ = trigger_.once;
}

bool ModifyList::takeDone() { return done_ && !std::exchange(told_, true); }

}  // namespace merker::workbench
