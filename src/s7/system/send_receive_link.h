// A connection of a CP 343-1 to that of another station of the project, for AG_SEND and AG_RECV: a
// job is a telegram on the subnet, which the other CP confirms. Of UDP nothing is confirmed.
#pragma once

#include <span>

#include "network/node.h"
#include "system/send_receive.h"

namespace merker::system {

// In front of each telegram; those of S7 connections (LinkMessage) begin otherwise.
enum class CpMessage : std::uint8_t { Connect = 0x58, Accept, Data, Taken, Full, End };

class SendReceiveLink {
 public:
  using View = std::span<const std::uint8_t>;

  // The node outlives it. `place`: among the connections that blocks name.
  SendReceiveLink(const network::ConnectionEnd& end, std::size_t place)
      : end_(end), place_(place) {}

  const network::ConnectionEnd& end() const { return end_; }

  void hear(CpMessage message, View octets, SendReceive& program, Instant now);
  // What is due: calls, and partners that do not answer.
  void move(SendReceive& program, Instant now);
  // At the end of a cycle: what the program sends.
  void exchange(SendReceive& program, Instant now);
  // The station is without power.
  void fall(SendReceive& program);
  void rise(Instant now) { due_ = now; }
  // When move() is to be called.
  Instant next() const;

 private:
  enum class State : std::uint8_t { Idle, Calling, Up, Waiting };  // Waiting: for Taken
  bool datagrams() const { return end_.kind == ConnectionKind::Udp; }
  void send(CpMessage message, Instant now, View octets = {});
  void open(SendReceive& program);
  void close(SendReceive& program, Instant now);
  void take(View octets, SendReceive& program, Instant now);
  void finish(std::uint16_t result, SendReceive& program);

  network::ConnectionEnd end_;
  std::size_t place_;
  State state_ = State::Idle;
  Instant due_;  // the next call, or the latest answer
};

}  // namespace merker::system
