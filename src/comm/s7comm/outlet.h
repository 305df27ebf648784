// What a PLC tells a client unasked, on its way from the thread of the PLC to that of the
// connections. Bounded: what a client that does not read leaves behind is lost, and counted.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "s7comm/pdu.h"

namespace merker::s7comm {

// Userdata of type 0. Its data have their head when they are sent; none: a head without octets.
struct Indication {
  std::uint8_t group = 0, subfunction = 0, sequence = 0;
  Error error = Error::None;
  Bytes octets{};
};

class Outlet {
 public:
  static constexpr std::size_t kMostWaiting = 64;  // indications of a PDU each

  // In the thread of the PLC. False: nobody takes it, it is lost.
  bool send(Indication one);
  // True: something waits and nobody has been told; the caller has deliver() called.
  bool announce();
  bool isClosed() const { return closed_; }
  std::size_t room() const { return room_; }  // octets that one may have
  std::uint64_t lost() const { return lost_; }

  // In the thread of the connections.
  void deliver();
  void deliverBy(std::function<void()> deliver) { deliver_ = std::move(deliver); }
  void setRoom(std::size_t octets) { room_ = octets; }
  std::optional<Indication> take();
  void close();

 private:
  std::atomic<bool> closed_ = false, announced_ = false;
  std::atomic<std::size_t> room_ = 0;
  std::atomic<std::uint64_t> lost_ = 0;
  mutable std::mutex mutex_;  // of what follows
  std::function<void()> deliver_;
  std::deque<Indication> waiting_;
};

}  // namespace merker::s7comm
