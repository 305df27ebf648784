// A UDP connection of a CP 343-1: datagrams of its partner alone come in, each job is one.
#include <array>
#include <boost/asio/ip/udp.hpp>

#include "cp_sockets.h"

namespace merker::app {
namespace {

using boost::asio::ip::udp;
using system::SendReceive;

class CpDatagrams final : public CpSocket, public std::enable_shared_from_this<CpDatagrams> {
 public:
  explicit CpDatagrams(CpPlace place)
      : place_(std::move(place)),
        partner_(boost::asio::ip::make_address(place_.parameters().host), place_.parameters().port),
        socket_(place_.context) {}

  void look() override {
    if (socket_.is_open() || closed_) return;
    boost::system::error_code error;
    const udp::endpoint own(boost::asio::ip::make_address(place_.address),
                            place_.parameters().localPort);
    socket_.open(own.protocol(), error);
    if (!error) socket_.bind(own, error);
    if (!error) socket_.non_blocking(true, error);
    if (error) return fail(error.message());
    place_.lines.connected(place_.i, true);
    read();
  }

  // What the computer does not take at once is lost, as datagrams may be.
  void move() override {
    if (!socket_.is_open()) return;
    const auto data = place_.lines.toSend(place_.i);
    if (!data) return;
    boost::system::error_code ignored;
    socket_.send_to(boost::asio::buffer(*data), partner_, 0, ignored);
    place_.lines.ended(place_.i, SendReceive::kSent);
  }

  void close() override {
    closed_ = true;
    if (socket_.is_open()) place_.lines.connected(place_.i, false);
    boost::system::error_code ignored;
    socket_.close(ignored);
  }

 private:
  void fail(const std::string& why) {
    boost::system::error_code ignored;
    socket_.close(ignored);
    if (!std::exchange(told_, true)) tellNoPort(place_, why);
  }

  // Always: a datagram without room is lost, as in a CP.
  void read() {
    socket_.async_receive_from(
        boost::asio::buffer(buffer_), from_,
        [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
          if (self->closed_ || error == boost::asio::error::operation_aborted) return;
          if (!error) self->received(count);
          self->read();
        });
  }
  void received(std::size_t count) {
    const bool mine = from_ == partner_ && count <= SendReceive::kLongestDatagram;
    if (mine && place_.lines.hasRoom(place_.i))
      place_.lines.arrived(place_.i, {buffer_.begin(), buffer_.begin() + static_cast<long>(count)});
  }

  CpPlace place_;
  udp::endpoint partner_, from_;
  udp::socket socket_;
  bool closed_ = false, told_ = false;
  std::array<std::uint8_t, SendReceive::kLongestDatagram + 1> buffer_{};
};

}  // namespace

std::shared_ptr<CpSocket> datagramsOf(const CpPlace& place) {
  return std::make_shared<CpDatagrams>(place);
}

}  // namespace merker::app
