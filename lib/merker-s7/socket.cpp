#include "socket.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <memory>

#include "merker_s7.h"

namespace merker::s7client {
namespace {

using Clock = std::chrono::steady_clock;

int left(Clock::time_point end) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
  return ms < 0 ? 0 : static_cast<int>(ms);
}

}  // namespace

bool Socket::wait(short events, int milliseconds) const {
  const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
  for (;;) {
    pollfd what{handle_, events, 0};
    const int ready = ::poll(&what, 1, left(end));
    if (ready >= 0) return ready > 0;
    if (errno != EINTR) return false;
  }
}

int Socket::open(const addrinfo& where, int milliseconds) {
  handle_ = ::socket(where.ai_family, where.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (handle_ < 0) return errTCPSocketCreation;
  const int on = 1;  // requests are small and wait for their answers
  ::setsockopt(handle_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (::connect(handle_, where.ai_addr, where.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errTCPConnectionFailed;
  if (!wait(POLLOUT, milliseconds)) return errTCPConnectionTimeout;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(handle_, SOL_SOCKET, SO_ERROR, &error, &size);
  return error == 0 ? 0 : errTCPConnectionFailed;
}

int Socket::connect(const std::string& address, std::uint16_t port, int milliseconds) {
  close();
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  if (::getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &list) != 0)
    return errTCPConnectionFailed;
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(list, &::freeaddrinfo);
  int error = errTCPConnectionFailed;
  for (const addrinfo* at = list; at != nullptr; at = at->ai_next) {
    error = open(*at, milliseconds);
    if (error == 0) return 0;
    close();
  }
  return error;
}

int Socket::send(std::span<const std::uint8_t> bytes, int milliseconds) {
  if (!isOpen()) return errTCPNotConnected;
  while (!bytes.empty()) {
    const ssize_t sent = ::send(handle_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent > 0) bytes = bytes.subspan(static_cast<std::size_t>(sent));
    if (sent >= 0 || errno == EINTR) continue;
    if (errno != EAGAIN) return errTCPDataSend;
    if (!wait(POLLOUT, milliseconds)) return errTCPSendTimeout;
  }
  return 0;
}

int Socket::receive(std::span<std::uint8_t> bytes, int milliseconds, std::size_t& count) {
  if (!isOpen()) return errTCPNotConnected;
  if (!wait(POLLIN, milliseconds)) return errTCPReceiveTimeout;
  const ssize_t received = ::recv(handle_, bytes.data(), bytes.size(), 0);
  if (received == 0) return errTCPConnectionReset;
  if (received < 0) return errTCPDataReceive;
  count = static_cast<std::size_t>(received);
  return 0;
}

void Socket::close() {
  if (handle_ >= 0) ::close(handle_);
  handle_ = -1;
}

}  // namespace merker::s7client
