// Local data that the compiler uses for the macros of one statement: bytes are given one behind the
// other, nothing is aligned; bits fill a byte of their own, also if others were given in between.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "address/area.h"

namespace merker::step7 {

class LocalData {
 public:
  explicit LocalData(std::uint32_t base = 0) : base_(base), next_(base), top_(base) {}

  // Another statement begins: what the last one used is free.
  void begin() {
    next_ = base_;
    bits_ = 0;
  }
  // The first of `count` bytes.
  std::uint32_t bytes(std::uint32_t count) {
    const std::uint32_t first = next_;
    next_ += count;
    top_ = std::max(top_, next_);
    return first;
  }
  BitAddress bit() {
    if (bits_ % 8 == 0) bits_ = bytes(1) * 8;
    return bits_++;
  }
  // In KOP and FUP each network has a base of its own.
  void moveTo(std::uint32_t base) {
    base_ = base;
    begin();
  }
  std::uint32_t top() const { return top_; }  // behind the highest byte ever used
  bool used() const { return top_ != base_; }

 private:
  std::uint32_t base_, next_, top_;
  BitAddress bits_ = 0;  // of the next bit; a multiple of 8: a new byte is needed
};

// How far the absolute local operands of each network reach, in bytes: KOP and FUP give the places
// of their temporary bits anew in each (code patterns, section 1). Known from the second pass on.
class NetworkTops {
 public:
  void restart() {
    known_ = std::move(seen_);
    seen_.clear();
  }
  void end(std::uint32_t top) {
    seen_.push_back(top);
    highest_ = std::max(highest_, top);
  }
  // Of the network that begins now.
  std::uint32_t next() const { return seen_.size() < known_.size() ? known_[seen_.size()] : 0; }
  std::uint32_t highest() const { return highest_; }

 private:
  std::vector<std::uint32_t> known_, seen_;
  std::uint32_t highest_ = 0;
};

}  // namespace merker::step7
