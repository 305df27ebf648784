// items: [{operand, value, format}] of a request.
#pragma once

#include <string>
#include <vector>

#include "monitor/monitor.h"
#include "workbench/fields.h"

namespace merker::workbench {

monitor::DisplayFormat formatOf(const Fields& item);

class Wishes {
 public:
  explicit Wishes(const Fields& fields);
  // They look at the texts in here.
  std::vector<monitor::Wish> list() const;

 private:
  struct Texts {
    std::string operand, value;
    monitor::DisplayFormat format;
  };
  std::vector<Texts> texts_;
};

}  // namespace merker::workbench
