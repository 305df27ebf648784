// What the places of pages hold: read from the copy of the last end of a cycle, so that no page
// makes the PLC wait. Which operand a name is, only the PLC's thread knows; it is asked once for
// each.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "itcp/page_template.h"
#include "served/exchange.h"

namespace merker::itcp {

class PageValues : public std::enable_shared_from_this<PageValues> {
 public:
  using Done = std::function<void(const std::vector<PageValue>&)>;

  // The PLC outlives it.
  explicit PageValues(served::Exchange& plc) : plc_(plc) {}

  // In the thread of the connections, as all of it; `done` within the call or later.
  void read(std::vector<std::string> names, Done done);
  // Another program may be in the PLC: names are looked up again.
  void forget() { known_.clear(); }

 private:
  struct Known {
    std::optional<address::Reference> operand;
    std::string why;  // there is none
  };
  using Found = std::vector<std::pair<std::string, Known>>;
  static Found lookUp(const std::vector<std::string>& names, const monitor::Monitor* monitor);
  void answer(const std::vector<std::string>& names, Done done);

  served::Exchange& plc_;
  std::map<std::string, Known, std::less<>> known_;
};

}  // namespace merker::itcp
