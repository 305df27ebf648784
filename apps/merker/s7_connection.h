// A client of the S7 server: its socket, its transport connection, its session. Everything in the
// thread of the server.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <memory>

#include "iso/transport.h"
#include "s7_incidents.h"
#include "s7comm/session.h"
#include "served/exchange.h"
#include "served/password_guard.h"
#include "served/resources.h"
#include "workbench/communication_view.h"

namespace merker::app {

// Whether a way leads to the station now, for clients that come by the server of another one.
using S7WayOpen = std::shared_ptr<const std::atomic<bool>>;
// Whose client it is: of this server, of another one that has it now, of one that no way leads to.
enum class S7Whose : std::uint8_t { Own, Passed, NoWay };

// What all clients share; it outlives them.
struct S7Surroundings {
  served::Exchange exchange{};
  served::Resources resources{};
  CommunicationParameters parameters{};
  void use(const CommunicationParameters& wanted) {
    parameters = wanted;
    resources.limit(wanted);
    exchange.partners().configure(wanted.configured);
  }
  S7Incidents incidents{};
  served::PasswordGuard passwords{};
  // Gives a client that calls another station to the server of that one, with what it has sent so
  // far: the socket is released.
  std::function<S7Whose(boost::asio::ip::tcp::socket& client, iso::View called, iso::View sent)>
      passOn{};
  // Takes a connection resource of this kind from whoever has one and never set up its connection.
  std::function<bool(served::Resource kind)> makeRoom{};
};

class S7Connection : public std::enable_shared_from_this<S7Connection> {
 public:
  using Clock = std::chrono::steady_clock;
  using Socket = boost::asio::ip::tcp::socket;
  using Endpoint = boost::asio::ip::tcp::endpoint;

  // Of a client that has called.
  S7Connection(Socket socket, S7Surroundings& around);
  // Of the partner of a configured connection that is called.
  S7Connection(Socket socket, S7Surroundings& around, std::size_t configured);
  ~S7Connection();
  S7Connection(const S7Connection&) = delete;
  S7Connection& operator=(const S7Connection&) = delete;

  // `sent`: what the client has sent to a server that has passed it on, `way`: from there.
  void begin(iso::View sent = {}, S7WayOpen way = {});
  // Nothing leads from where it came in to this station any more.
  bool cutOff() const { return way_ != nullptr && !*way_; }
  void call(const Endpoint& there);
  bool closed() const { return closed_; }
  // It took too long for what is expected of it.
  bool overdue(Clock::time_point now) const { return now >= due_; }
  // Nothing has been agreed with it yet.
  bool isNew() const { return expected_ == Expected::Request || expected_ == Expected::Setup; }
  Clock::time_point due() const { return due_; }
  bool holds(served::Resource kind) const { return session_ && !configured_ && resource_ == kind; }
  void breakOff(S7Why why);
  // What was expected of it has not come.
  void breakOffLate();
  void close();
  // The place of its configured connection; nothing: it is a client.
  const std::optional<std::size_t>& configured() const { return configured_; }
  // Nothing: it is not connected, or it is the partner of a configured connection.
  std::optional<workbench::S7ClientRow> row(Clock::time_point now) const;

 private:
  // What is expected of the client.
  enum class Expected : std::uint8_t { Request, Setup, RestOfMessage, Reading, Answer, Nothing };

  void read();
  void received(std::size_t count);
  void pump();
  void handle(iso::Event& event);
  void refuse(iso::Reason reason, S7Why why);
  void note(S7Why why) { around_.incidents.note(address_, why); }
  s7comm::Session::Guard guard();
  void denied(s7comm::Error error);
  void whenItsTurn(const std::function<void(bool)>& look);
  void requested(const iso::ConnectParameters& parameters);
  void confirmed();
  void serve();
  bool hear(iso::View pdu);
  bool hearPartner(iso::View pdu);
  void attachPartner();
  s7comm::Partner& partner() { return around_.exchange.partners().partner(*configured_); }
  bool takesConfigured(const iso::ConnectParameters& parameters);
  void prepare();
  void send(iso::View pdu);
  void flush();
  void sent();
  void expect(bool moved);
  Expected expected() const;
  bool partnerAsks() const;

  Socket socket_;
  S7Surroundings& around_;
  iso::Transport transport_;
  std::optional<std::size_t> configured_;
  bool attached_ = false;                     // its partner has this transport connection
  std::shared_ptr<s7comm::Session> session_;  // once it is connected
  std::string partner_, address_;
  Clock::time_point since_{};  // it is connected
  std::uint64_t requests_ = 0, received_ = 0, sent_ = 0;
  served::Resource resource_ = served::Resource::Basic;
  std::array<std::uint8_t, 16'384> buffer_{};
  iso::Bytes out_, sending_;
  iso::Bytes head_;  // what came before the connection stood
  S7WayOpen way_;    // null: no other server has passed it on
  bool reading_ = false, pumping_ = false, ending_ = false, closed_ = false;
  Expected expected_ = Expected::Nothing;
  Clock::time_point due_ = Clock::time_point::max();
};

// Its address and port; its address.
std::string partnerOf(const S7Connection::Socket& socket);
std::string addressOf(const S7Connection::Socket& socket);

}  // namespace merker::app
