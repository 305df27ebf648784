// The sockets of a CP 343-1's connections to partners outside: TCP, ISO on TCP, UDP, e-mail.
// Everything in the thread of the S7 server; a partner that says nothing or too much stops nobody.
#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "served/cp_lines.h"
#include "workbench/communication_view.h"

namespace merker::app {

// One connection.
class CpSocket {
 public:
  virtual ~CpSocket() = default;
  // There is something to send, or room for what comes.
  virtual void move() = 0;
  // Every now and then: calls, and time limits.
  virtual void look() = 0;
  virtual void close() = 0;

 protected:
  CpSocket() = default;
  CpSocket(const CpSocket&) = default;
  CpSocket& operator=(const CpSocket&) = default;
};

class CpSockets {
 public:
  // `address`: where this side listens; one of this computer alone calls nobody else.
  CpSockets(boost::asio::io_context& context, served::CpLines& lines, std::string address)
      : context_(context), lines_(lines), address_(std::move(address)) {}
  ~CpSockets() { close(); }
  CpSockets(const CpSockets&) = delete;
  CpSockets& operator=(const CpSockets&) = delete;

  void use(const std::vector<CpConnectionParameters>& connections);
  // Every now and then. Without power nobody listens, and what stands is closed.
  void look(bool powered);
  void close();
  std::vector<workbench::CpConnectionRow> rows() const;

 private:
  void open();
  bool reaches(std::size_t i) const;
  std::shared_ptr<CpSocket> socketOf(std::size_t i);

  boost::asio::io_context& context_;
  served::CpLines& lines_;
  std::string address_;
  std::vector<std::shared_ptr<CpSocket>> sockets_;
  bool open_ = false;
};

// What opens them; of `lines` the connection `i`.
struct CpPlace {
  boost::asio::io_context& context;
  served::CpLines& lines;
  std::size_t i;
  std::string address;  // of this side
  const CpConnectionParameters& parameters() const { return lines.parameters(i); }
};
std::shared_ptr<CpSocket> streamOf(const CpPlace& place);
std::shared_ptr<CpSocket> datagramsOf(const CpPlace& place);
std::shared_ptr<CpSocket> mailsOf(const CpPlace& place);
// "merker: connection 3 of the CP: port 2000 of 127.0.0.1 cannot be used: …"
void tellNoPort(const CpPlace& place, const std::string& why);

}  // namespace merker::app
