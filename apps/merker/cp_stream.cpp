// A TCP or ISO-on-TCP connection of a CP 343-1. The active side calls until the partner answers,
// the other one listens; of two calls of its partner the later one counts, since it has begun anew.
#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <functional>

#include "cp_sockets.h"
#include "iso/transport.h"

namespace merker::app {
namespace {

using boost::asio::ip::tcp;
using system::SendReceive;
using CpClock = std::chrono::steady_clock;
using CpError = boost::system::error_code;

// Between two calls; for a connection to be made; for a partner to take what is sent.
constexpr std::chrono::seconds kCallAgain(1), kToConnect(5), kToTake(10);

// A connection that stands, or is being made.
class CpStream : public std::enable_shared_from_this<CpStream> {
 public:
  CpStream(const CpPlace& place, tcp::socket socket, bool calls)
      : place_(place),
        socket_(std::move(socket)),
        transport_(calls ? iso::Transport::Side::Calling : iso::Transport::Side::Called) {}

  bool closed() const { return closed_; }
  // Called when it stands: the one before it goes.
  void replaces(std::function<void()> other) { standing_ = std::move(other); }
  void call() {
    const CpConnectionParameters& there = parameters();
    socket_.async_connect({boost::asio::ip::make_address(there.host), there.port},
                          [self = shared_from_this()](CpError error) {
                            if (!self->closed_) error ? self->close() : self->begin();
                          });
  }
  void begin() {
    CpError ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    socket_.set_option(boost::asio::socket_base::keep_alive(true), ignored);
    if (!isIso()) return stand();
    const bool calls = parameters().active;
    if (calls)
      write(transport_.request({.sizeCode = std::nullopt,
                                .calling = parameters().localTsap,
                                .called = parameters().partnerTsap}));
    read();
  }
  void move() {
    if (!stands_) return;
    if (out_.empty()) {
      if (const auto data = place_.lines.toSend(place_.i)) send(*data);
    }
    read();
  }
  void look() {
    if (!closed_ && CpClock::now() >= due_) late();
  }
  void close() {
    if (std::exchange(closed_, true)) return;
    CpError ignored;
    socket_.close(ignored);
    if (stands_) place_.lines.connected(place_.i, false);
  }

 private:
  const CpConnectionParameters& parameters() const { return place_.parameters(); }
  bool isIso() const { return parameters().kind == ConnectionKind::IsoOnTcp; }

  void stand() {
    if (const auto other = std::exchange(standing_, {})) other();
    stands_ = true;
    due_ = CpClock::time_point::max();
    place_.lines.connected(place_.i, true);
    read();
  }
  // The partner takes nothing, or never says who it is.
  void late() {
    if (sends_) place_.lines.ended(place_.i, SendReceive::kNotTaken);
    close();
  }

  void send(const SendReceive::Bytes& data) {
    iso::Bytes out;
    isIso() ? transport_.write(out, data) : out.assign(data.begin(), data.end());
    sends_ = true;
    due_ = CpClock::now() + kToTake;
    write(std::move(out));
  }
  void write(iso::Bytes out) {
    out_ = std::move(out);
    boost::asio::async_write(socket_, boost::asio::buffer(out_),
                             [self = shared_from_this()](CpError error, std::size_t) {
                               if (self->closed_) return;
                               error ? self->close() : self->written();
                             });
  }
  void written() {
    out_.clear();
    if (!std::exchange(sends_, false)) return;
    due_ = CpClock::time_point::max();
    place_.lines.ended(place_.i, SendReceive::kSent);
    move();
  }

  // Nothing is read for which there is no room: TCP then holds the partner.
  void read() {
    hear();
    if (reading_ || closed_ || !place_.lines.hasRoom(place_.i)) return;
    reading_ = true;
    socket_.async_read_some(boost::asio::buffer(buffer_),
                            [self = shared_from_this()](CpError error, std::size_t count) {
                              self->reading_ = false;
                              if (self->closed_) return;
                              error ? self->close() : self->received(count);
                            });
  }
  void received(std::size_t count) {
    const std::span<const std::uint8_t> bytes(buffer_.data(), count);
    if (isIso())
      transport_.feed(bytes);
    else
      place_.lines.arrived(place_.i, {bytes.begin(), bytes.end()});
    read();
  }
  // Messages that have come, as long as there is room.
  void hear() {
    if (std::exchange(hearing_, true)) return;
    while (!closed_ && place_.lines.hasRoom(place_.i)) {
      auto event = transport_.next();
      if (!event) break;
      handle(*event);
    }
    hearing_ = false;
  }
  void handle(iso::Event& event) {
    using Kind = iso::Event::Kind;
    if (event.kind == Kind::Requested && isMine(event.parameters)) {
      write(transport_.confirm());
      return stand();
    }
    if (event.kind == Kind::Confirmed) return stand();
    if (event.kind != Kind::Message || event.message.size() > SendReceive::kLongest) return close();
    place_.lines.arrived(place_.i, std::move(event.message));
  }
  bool isMine(const iso::ConnectParameters& asked) const {
    return std::ranges::equal(asked.called, parameters().localTsap) &&
           std::ranges::equal(asked.calling, parameters().partnerTsap);
  }

  CpPlace place_;
  tcp::socket socket_;
  iso::Transport transport_;
  iso::Bytes out_;
  std::function<void()> standing_;
  bool stands_ = false, sends_ = false, reading_ = false, hearing_ = false, closed_ = false;
  CpClock::time_point due_ = CpClock::now() + kToConnect;
  std::array<std::uint8_t, SendReceive::kLongest> buffer_{};
};

class CpStreams final : public CpSocket, public std::enable_shared_from_this<CpStreams> {
 public:
  explicit CpStreams(CpPlace place) : place_(std::move(place)), acceptor_(place_.context) {}

  void move() override {
    if (stream_) stream_->move();
  }
  void look() override {
    if (stream_) stream_->look();
    if (caller_) caller_->look();
    place_.parameters().active ? call() : listen();
  }
  void close() override {
    closed_ = true;
    CpError ignored;
    acceptor_.close(ignored);
    if (stream_) stream_->close();
    if (caller_) caller_->close();
  }

 private:
  void call() {
    const auto now = CpClock::now();
    if ((stream_ && !stream_->closed()) || now < next_) return;
    next_ = now + kCallAgain;
    stream_ = std::make_shared<CpStream>(place_, tcp::socket(place_.context), true);
    stream_->call();
  }
  void listen() {
    if (acceptor_.is_open()) return;
    CpError error;
    const tcp::endpoint own(boost::asio::ip::make_address(place_.address),
                            place_.parameters().localPort);
    acceptor_.open(own.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(own, error);
    if (!error) acceptor_.listen(1, error);
    if (!error) return accept();
    CpError ignored;
    acceptor_.close(ignored);
    if (!std::exchange(told_, true)) tellNoPort(place_, error.message());
  }
  void accept() {
    acceptor_.async_accept([self = shared_from_this()](CpError error, tcp::socket socket) {
      if (self->closed_ || error == boost::asio::error::operation_aborted) return;
      if (error) {  // no more descriptors, say: look() listens again
        CpError ignored;
        self->acceptor_.close(ignored);
        return;
      }
      self->take(std::move(socket));
      self->accept();
    });
  }
  void take(tcp::socket socket) {
    CpError gone;
    const auto there = socket.remote_endpoint(gone);
    if (gone || there.address().to_string() != place_.parameters().host) return;
    if (caller_) caller_->close();
    caller_ = std::make_shared<CpStream>(place_, std::move(socket), false);
    caller_->replaces([this] {
      if (stream_) stream_->close();
      stream_ = std::exchange(caller_, {});
    });
    std::shared_ptr(caller_)->begin();
  }

  CpPlace place_;
  tcp::acceptor acceptor_;
  std::shared_ptr<CpStream> stream_, caller_;  // caller_: has not said yet who it is
  CpClock::time_point next_{};
  bool closed_ = false, told_ = false;
};

}  // namespace

std::shared_ptr<CpSocket> streamOf(const CpPlace& place) {
  return std::make_shared<CpStreams>(place);
}

}  // namespace merker::app
