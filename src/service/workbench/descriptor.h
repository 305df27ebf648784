// An open file or folder of the operating system.
#pragma once

#include <unistd.h>

#include <utility>

namespace merker::workbench {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }
  // Whoever takes it closes it.
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

}  // namespace merker::workbench
