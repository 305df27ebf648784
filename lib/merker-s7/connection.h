// A connection to a CPU: a PDU goes, its answer comes.
#pragma once

#include <string>

#include "iso/transport.h"
#include "s7comm/pdu.h"
#include "socket.h"

namespace merker::s7client {

struct Settings {
  std::string address;
  std::uint16_t port = 102;
  std::uint16_t type = 1;  // connection resource of the CPU
  int rack = 0, slot = 2;
  std::int32_t connectMilliseconds = 750, sendMilliseconds = 10, receiveMilliseconds = 3000;
  std::int32_t pdu = 480;
};

class Connection {
 public:
  // TCP, transport connection, setup. 0, or an error of merker_s7.h; it is closed then.
  int open(const Settings& settings);
  void close();
  bool isOpen() const { return socket_.isOpen(); }
  // How long the CPU may take for an answer, ms.
  int patience() const { return settings_.receiveMilliseconds; }
  void setPatience(int milliseconds) { settings_.receiveMilliseconds = milliseconds; }
  std::uint16_t pdu() const { return pdu_; }

  std::uint16_t nextReference() { return ++reference_; }
  // Answers with another reference are of requests that took too long, and are dropped. The answer
  // lies in the connection until the next exchange.
  int exchange(s7comm::View request, std::uint16_t reference, s7comm::Pdu& answer);
  // The CPU asks, too: its next PDU, and the answer to it.
  int heard(s7comm::Pdu& pdu);
  int reply(s7comm::View answer);

 private:
  int call();
  int setUp();
  int send(s7comm::View message);
  int nextEvent(iso::Event& event);
  int nextPdu(s7comm::Pdu& pdu);
  int exchangeOpen(s7comm::View request, std::uint16_t reference, s7comm::Pdu& answer);

  Settings settings_;
  Socket socket_;
  iso::Transport transport_{iso::Transport::Side::Calling};
  iso::Bytes message_;
  std::uint16_t pdu_ = 0, reference_ = 0;
};

}  // namespace merker::s7client
