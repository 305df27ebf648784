#include "server/stream.h"

#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>

namespace merker::hmi {

using boost::asio::const_buffer;
using boost::asio::mutable_buffer;

class Stream::Wire {
 public:
  virtual ~Wire() = default;
  virtual beast::tcp_stream& tcp() = 0;
  virtual void handshake(Done done) = 0;
  virtual void tearDown(beast::role_type role, Done done) = 0;
  virtual void readSome(const Few<mutable_buffer>& buffers, Moved moved) = 0;
  virtual void writeSome(const Few<const_buffer>& buffers, Moved moved) = 0;

 protected:
  Wire() = default;
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
};

namespace {

using Plain = beast::tcp_stream;
using Secure = beast::ssl_stream<beast::tcp_stream>;

void shakeHands(Plain&, Stream::Done done) { done({}); }

void shakeHands(Secure& stream, Stream::Done done) {
  stream.async_handshake(boost::asio::ssl::stream_base::server, std::move(done));
}

void tear(beast::role_type role, Plain& stream, Stream::Done done) {
  beast::websocket::async_teardown(role, stream.socket(), std::move(done));
}

void tear(beast::role_type role, Secure& stream, Stream::Done done) {
  async_teardown(role, stream, std::move(done));
}

template <typename Layer>
class WireOf : public Stream::Wire {
 public:
  template <typename... Arguments>
  explicit WireOf(Arguments&&... arguments) : layer_(std::forward<Arguments>(arguments)...) {}

  beast::tcp_stream& tcp() override { return beast::get_lowest_layer(layer_); }
  void handshake(Stream::Done done) override { shakeHands(layer_, std::move(done)); }
  void tearDown(beast::role_type role, Stream::Done done) override {
    tear(role, layer_, std::move(done));
  }
  void readSome(const Stream::Few<mutable_buffer>& buffers, Stream::Moved moved) override {
    layer_.async_read_some(buffers, std::move(moved));
  }
  void writeSome(const Stream::Few<const_buffer>& buffers, Stream::Moved moved) override {
    layer_.async_write_some(buffers, std::move(moved));
  }

 private:
  Layer layer_;
};

}  // namespace

Stream::Stream(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls) {
  if (tls == nullptr)
    wire_ = std::make_unique<WireOf<Plain>>(std::move(socket));
  else
    wire_ = std::make_unique<WireOf<Secure>>(Plain(std::move(socket)), *tls);
}

Stream::Stream(Stream&&) noexcept = default;
Stream& Stream::operator=(Stream&&) noexcept = default;
Stream::~Stream() = default;

beast::tcp_stream& Stream::next_layer() { return wire_->tcp(); }
const beast::tcp_stream& Stream::next_layer() const { return wire_->tcp(); }

void Stream::handshake(Done done) { wire_->handshake(std::move(done)); }
void Stream::tearDown(beast::role_type role, Done done) { wire_->tearDown(role, std::move(done)); }

void Stream::readSome(const Few<mutable_buffer>& buffers, Moved moved) {
  wire_->readSome(buffers, std::move(moved));
}
void Stream::writeSome(const Few<const_buffer>& buffers, Moved moved) {
  wire_->writeSome(buffers, std::move(moved));
}

}  // namespace merker::hmi
