// A file descriptor of a serial stream, closed at its end.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace merker::app {

class SerialFile {
 public:
  explicit SerialFile(int number = -1) : number_(number) {}
  ~SerialFile() { reset(); }
  SerialFile(SerialFile&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  SerialFile& operator=(SerialFile&& other) noexcept {
    if (this != &other) reset(std::exchange(other.number_, -1));
    return *this;
  }
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  void reset(int number = -1) {
    if (number_ >= 0) ::close(number_);
    number_ = number;
  }

 private:
  int number_;
};

inline std::string whyNot(const std::string& what) { return what + ": " + std::strerror(errno); }
inline bool wouldWait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace merker::app
