// S7 servers of the workbench: of the PLC that it shows, or of each station of a project of several
// (S7-NET-01), whichever of them is shown.
#pragma once

#include <deque>

#include "s7_desk.h"
#include "s7_ways.h"

namespace merker::app {

class LaboratoryS7 {
 public:
  // `workbench` outlives it.
  explicit LaboratoryS7(workbench::Workbench& workbench) : workbench_(workbench) {}

  // As S7Desk::open. A server for each station; for those of a project that is opened later, too.
  int open(const std::string& command, const S7Option& option, std::function<void()> wake);
  // In front of each slice of time.
  void exchange();
  bool waits() const;
  // Of the PLC that is shown.
  workbench::S7Outside outside() const;

 private:
  using Laboratory = workbench::Laboratory;
  workbench::Plc* plcOf(const Laboratory* lab, std::size_t i) const;
  int add(const Laboratory* lab);
  void follow(const std::shared_ptr<Laboratory>& lab);

  workbench::Workbench& workbench_;
  std::string command_;
  S7Place first_;
  std::function<void()> wake_;
  std::deque<S7Desk> desks_;  // the first one goes first: it passes clients on
  S7Ways ways_;
  std::weak_ptr<Laboratory> lab_;
  std::uint64_t shown_ = UINT64_MAX;
};

}  // namespace merker::app
