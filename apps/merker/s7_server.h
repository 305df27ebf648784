// The S7 server: listens, and carries PDUs between clients and a PLC. A thread of its own.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "s7_connection.h"
#include "s7_option.h"

namespace merker::app {

class S7Server;
// To the server of another station.
struct S7Way {
  S7Server* server = nullptr;
  S7WayOpen open{};
};

class S7Server {
 public:
  // Null, and the reason, if it cannot listen. `wake`: the thread of the PLC has something to do.
  static std::unique_ptr<S7Server> start(const S7Place& place,
                                         const CommunicationParameters& parameters,
                                         std::function<void()> wake, std::string& reason);
  ~S7Server();  // all connections are closed
  S7Server(const S7Server&) = delete;
  S7Server& operator=(const S7Server&) = delete;

  served::Exchange& exchange();
  // For connections from now on; those that stand stay.
  void use(const CommunicationParameters& parameters);
  // Clients that call another station by the low byte of the TSAP go to its server, as long as
  // there is a way; without one they are refused, and those that have gone it are closed. The
  // others outlive this one.
  void passOn(std::map<std::uint8_t, S7Way> others);
  std::string place() const;    // "127.0.0.1:10102"
  std::string summary() const;  // "3 connections, 1 refused, 0 broken off, 120 requests, 2 denied"
  // Who is connected, at most a quarter of a second ago; from any thread.
  workbench::S7Outside outside() const;
  // What people must know of an address beyond this computer; else empty.
  std::string warning() const;

 private:
  void adopt(int descriptor, bool six, const iso::Bytes& sent, const S7WayOpen& way);
  struct Parts;
  explicit S7Server(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::app
