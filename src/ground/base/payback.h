// When it pays to compile a program that may end soon: as soon as what has been interpreted took as
// long as compiling would. However long the program runs, both together take at most twice the time
// of the better choice.
#pragma once

#include <cstdint>

namespace merker {

class Payback {
 public:
  // In interpreted instructions. None: it is not waited for.
  void begin(std::uint64_t price) { left_ = price; }
  void end() { left_ = 0; }
  bool waits() const { return left_ > 0; }
  // True once, with those that reach the price.
  bool spend(std::uint64_t instructions) {
    if (left_ == 0) return false;
    left_ -= left_ < instructions ? left_ : instructions;
    return left_ == 0;
  }

 private:
  std::uint64_t left_ = 0;
};

}  // namespace merker
