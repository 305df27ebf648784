// Length measurement: the positions at two edges of its input (technology manual 3.4.10;
// POS-JOB-19 to -25).
#pragma once

#include <cstdint>

#include "io/axis_channel.h"

namespace merker::positioning {

class Length {
 public:
  explicit Length(io::LengthEdges edges) : edges_(edges) {}

  // A started measurement is discarded, the values of the last one stay.
  void reset();
  void edge(bool rising, std::int64_t position);

  bool done() const { return done_; }
  // Of the last one that came to its end.
  std::int64_t begin() const { return begin_; }
  std::int64_t end() const { return end_; }
  std::int64_t length() const;

 private:
  bool begins(bool rising) const;
  bool ends(bool rising) const;

  io::LengthEdges edges_;
  bool running_ = false, done_ = false;
  std::int64_t started_ = 0;  // where the running one began
  std::int64_t begin_ = 0, end_ = 0;
};

}  // namespace merker::positioning
