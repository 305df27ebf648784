// A TCP connection with a time limit for everything that waits.
#pragma once

#include <cstdint>
#include <span>
#include <string>

struct addrinfo;

namespace merker::s7client {

class Socket {
 public:
  Socket() = default;
  ~Socket() { close(); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // 0, or an error of merker_s7.h. Times in milliseconds.
  int connect(const std::string& address, std::uint16_t port, int milliseconds);
  int send(std::span<const std::uint8_t> bytes, int milliseconds);
  // Some bytes into `bytes`; `count` of them came.
  int receive(std::span<std::uint8_t> bytes, int milliseconds, std::size_t& count);
  void close();
  bool isOpen() const { return handle_ >= 0; }

 private:
  bool wait(short events, int milliseconds) const;
  int open(const addrinfo& where, int milliseconds);
  int handle_ = -1;
};

}  // namespace merker::s7client
