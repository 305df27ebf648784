// Whether a program can send by itself over MPI: it calls a function of basic communication or of
// global data. Connections send without one; they are known by their configuration.
#pragma once

#include <memory>

#include "block/block.h"

namespace merker::station {

class Senders {
 public:
  // Remembers the answer for the program it was asked for last.
  bool in(const std::shared_ptr<const block::Program>& program);

 private:
  std::shared_ptr<const block::Program> seen_;
  bool found_ = false;
};

}  // namespace merker::station
