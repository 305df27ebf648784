// A connection, with TLS or without: the sessions above are compiled once for both. An operation
// costs one allocation more than the stream itself.
#pragma once

#include <array>
#include <boost/asio/async_result.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <functional>
#include <memory>
#include <utility>

namespace merker::hmi {

namespace beast = boost::beast;

class Stream {
 public:
  using executor_type = beast::tcp_stream::executor_type;
  using next_layer_type = beast::tcp_stream;
  using Moved = std::function<void(beast::error_code, std::size_t)>;
  using Done = std::function<void(beast::error_code)>;
  // What one call of the operating system takes; the rest is the next call's. Unused ones are
  // empty.
  template <typename Buffer>
  using Few = std::array<Buffer, 8>;

  // TLS where `tls` is given; it outlives the stream.
  Stream(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls);
  Stream(Stream&&) noexcept;
  Stream& operator=(Stream&&) noexcept;
  ~Stream();

  executor_type get_executor() { return next_layer().get_executor(); }
  beast::tcp_stream& next_layer();
  const beast::tcp_stream& next_layer() const;

  // As a server; without TLS it is done at once, from within the call.
  void handshake(Done done);
  void tearDown(beast::role_type role, Done done);

  // What Asio calls an AsyncReadStream and AsyncWriteStream.
  template <typename Buffers, typename Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return boost::asio::async_initiate<Handler, void(beast::error_code, std::size_t)>(
        [this](auto done, const auto& few) { readSome(few, shared(std::move(done))); }, handler,
        first<boost::asio::mutable_buffer>(buffers));
  }
  template <typename Buffers, typename Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    return boost::asio::async_initiate<Handler, void(beast::error_code, std::size_t)>(
        [this](auto done, const auto& few) { writeSome(few, shared(std::move(done))); }, handler,
        first<boost::asio::const_buffer>(buffers));
  }

  class Wire;

 private:
  void readSome(const Few<boost::asio::mutable_buffer>& buffers, Moved moved);
  void writeSome(const Few<boost::asio::const_buffer>& buffers, Moved moved);

  // A std::function can be copied, the operations of Beast cannot.
  template <typename Handler>
  static auto shared(Handler handler) {
    return [kept = std::make_shared<Handler>(std::move(handler))](auto... results) {
      auto once = std::move(*kept);
      std::move(once)(results...);
    };
  }

  template <typename Buffer, typename Buffers>
  static Few<Buffer> first(const Buffers& buffers) {
    Few<Buffer> few;
    std::size_t used = 0;
    const auto end = boost::asio::buffer_sequence_end(buffers);
    for (auto it = boost::asio::buffer_sequence_begin(buffers); it != end && used < few.size();
         ++it)
      if (const Buffer buffer(*it); buffer.size() > 0) few[used++] = buffer;
    return few;
  }

  std::unique_ptr<Wire> wire_;
};

// The end of a WebSocket; Beast finds it by its name.
template <typename Handler>
void async_teardown(beast::role_type role, Stream& stream, Handler&& handler) {
  stream.tearDown(role, [kept = std::make_shared<std::decay_t<Handler>>(
                             std::forward<Handler>(handler))](beast::error_code error) {
    auto once = std::move(*kept);
    std::move(once)(error);
  });
}

}  // namespace merker::hmi
