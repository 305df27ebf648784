// X27 of the PLC that the workbench shows, and the outside: the connection is opened with the
// project and closed with it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "serial_link.h"
#include "workbench/workbench.h"

namespace merker::app {

class SerialDesk {
 public:
  // `allowed`: what the user of the command line has asked for there or in the project named there;
  // it may go anywhere. A project that is opened later may only do what stays on this computer.
  SerialDesk(workbench::Workbench& workbench, std::optional<serial::Connection> allowed);
  // Of the PLC that is shown now.
  void use(std::unique_ptr<SerialLink> link);

  // In front of each slice of time.
  void exchange();
  workbench::SerialOutside outside() const;

 private:
  void follow();
  std::string whyNot(const serial::Connection& connection) const;

  workbench::Workbench& workbench_;
  std::optional<serial::Connection> allowed_, connection_;
  std::string project_;  // of the command line
  std::uint64_t shown_ = UINT64_MAX;
  std::unique_ptr<SerialLink> link_;
  std::string problem_;
};

}  // namespace merker::app
