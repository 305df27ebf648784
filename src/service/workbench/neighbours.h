// The PLCs of one server, as the requests of one of them see them (workbenches.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "workbench/json.h"

namespace merker::workbench {

class Neighbours {
 public:
  virtual ~Neighbours() = default;
  virtual Json rows() const = 0;
  // In use: with a project, or with a browser.
  virtual std::size_t count() const = 0;
  // The number of the PLC with this project; 0: none has it.
  virtual std::size_t whoHas(std::string_view folder) const = 0;
  // As soon as its request is answered.
  virtual void move(std::uint64_t browser, std::size_t number) = 0;

 protected:
  Neighbours() = default;
  Neighbours(const Neighbours&) = default;
  Neighbours& operator=(const Neighbours&) = default;
};

}  // namespace merker::workbench
