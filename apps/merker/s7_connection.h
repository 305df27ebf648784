// A client of the S7 server: its socket, its transport connection, its session. Everything in the
// thread of the server.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <deque>
#include <memory>

#include "iso/transport.h"
#include "s7comm/session.h"
#include "served/exchange.h"
#include "served/resources.h"
#include "workbench/communication_view.h"

namespace merker::app {

// Since the server began.
struct S7Counts {
  std::atomic<std::uint64_t> connections = 0;  // that were confirmed
  std::atomic<std::uint64_t> refused = 0;      // sockets and connection requests
  std::atomic<std::uint64_t> broken = 0;       // ended because they broke the protocol or a limit
  std::atomic<std::uint64_t> requests = 0;
};

struct S7Refused {
  std::string partner, why;
  std::chrono::steady_clock::time_point when;
};

// What all clients share; it outlives them.
struct S7Surroundings {
  static constexpr std::size_t kMostRefused = 16;  // remembered

  served::Exchange exchange{};
  served::Resources resources{};
  CommunicationParameters parameters{};
  void use(const CommunicationParameters& wanted) {
    parameters = wanted;
    resources.limit(wanted);
  }
  S7Counts counts{};
  std::deque<S7Refused> refused{};  // the newest first
  void refuse(std::string partner, std::string why) {
    ++counts.refused;
    refused.push_front({std::move(partner), std::move(why), std::chrono::steady_clock::now()});
    if (refused.size() > kMostRefused) refused.pop_back();
  }
};

class S7Connection : public std::enable_shared_from_this<S7Connection> {
 public:
  using Clock = std::chrono::steady_clock;
  using Socket = boost::asio::ip::tcp::socket;

  S7Connection(Socket socket, S7Surroundings& around);
  ~S7Connection();
  S7Connection(const S7Connection&) = delete;
  S7Connection& operator=(const S7Connection&) = delete;

  void begin();
  bool closed() const { return closed_; }
  // It took too long for what is expected of it.
  bool overdue(Clock::time_point now) const { return now >= due_; }
  // Nothing has been agreed with it yet.
  bool isNew() const { return expected_ == Expected::Request || expected_ == Expected::Setup; }
  Clock::time_point due() const { return due_; }
  void breakOff();
  void close();
  // Nothing: it is not connected.
  std::optional<workbench::S7ClientRow> row(Clock::time_point now) const;

 private:
  // What is expected of the client.
  enum class Expected : std::uint8_t { Request, Setup, RestOfMessage, Reading, Answer, Nothing };

  void read();
  void received(std::size_t count);
  void pump();
  void handle(iso::Event& event);
  void refuse(iso::Reason reason, const char* why);
  void requested(const iso::ConnectParameters& parameters);
  void send(iso::View pdu);
  void flush();
  void sent();
  void expect(bool moved);
  Expected expected() const;

  Socket socket_;
  S7Surroundings& around_;
  iso::Transport transport_{iso::Transport::Side::Called};
  std::shared_ptr<s7comm::Session> session_;  // once it is connected
  std::string partner_;
  Clock::time_point since_{};  // it is connected
  std::uint64_t requests_ = 0, received_ = 0, sent_ = 0;
  served::Resource resource_ = served::Resource::Basic;
  std::array<std::uint8_t, 16'384> buffer_{};
  iso::Bytes out_, sending_;
  bool reading_ = false, pumping_ = false, ending_ = false, closed_ = false;
  Expected expected_ = Expected::Nothing;
  Clock::time_point due_ = Clock::time_point::max();
};

// Its address and port.
std::string partnerOf(const S7Connection::Socket& socket);

}  // namespace merker::app
