#include "workbench/modify_list.h"

namespace merker::workbench {

Result<ModifyList> ModifyList::of(monitor::Monitor& monitor,
                                  const std::vector<monitor::Wish>& wishes,
                                  monitor::Trigger trigger) {
  ModifyList list;
  list.trigger_ = trigger;
  for (const monitor::Wish& wish : wishes) {
    auto reference = monitor.operand(wish.operand);
    if (!reference) return reference.error();
    auto value = monitor::parse(*reference, wish.value, wish.format);
    if (!value) return value.error();
    if (auto problem = monitor.checkWrite(*reference)) return *problem;
    list.rows_.emplace_back(std::move(*reference), std::move(value.value()));
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
