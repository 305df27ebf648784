#include "positioning/length.h"

#include <cstdlib>

namespace merker::positioning {

using io::LengthEdges;

void Length::reset() { running_ = done_ = false; }

bool Length::begins(bool rising) const {
  const bool byRising = edges_ == LengthEdges::Rising || edges_ == LengthEdges::RisingFalling;
  return rising == byRising;
}

bool Length::ends(bool rising) const {
  const bool both = edges_ == LengthEdges::RisingFalling || edges_ == LengthEdges::FallingRising;
  return both ? !begins(rising) : begins(rising);
}

void Length::edge(bool rising, std::int64_t position) {
  if (edges_ == LengthEdges::Off) return;
  if (running_ && ends(rising)) {
    running_ = false;
    done_ = true;
    begin_ = started_;
    end_ = position;
  } else if (begins(rising)) {
    running_ = true;
    done_ = false;
    started_ = position;
  }
}

std::int64_t Length::length() const { return std::abs(end_ - begin_); }

}  // namespace merker::positioning
