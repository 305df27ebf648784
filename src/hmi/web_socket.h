// One browser: texts in both directions, over TCP or TLS.
#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>

#include "hmi/answer.h"
#include "hmi/sessions.h"

namespace merker::hmi {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

template <typename Stream>
class WebSocket : public Connection, public std::enable_shared_from_this<WebSocket<Stream>> {
 public:
  WebSocket(Stream stream, Surroundings& around) : stream_(std::move(stream)), around_(around) {
    ++around_.connections;
  }
  ~WebSocket() override {
    --around_.connections;
    if (id_ == 0) return;
    around_.browsers.remove(id_);
    around_.handler.closed(id_);
  }
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  void accept(const Request& request) {
    beast::get_lowest_layer(stream_).expires_never();
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.read_message_max(around_.options.limits.message);
    stream_.async_accept(request, [self = this->shared_from_this()](beast::error_code error) {
      if (!error) self->accepted();
    });
  }

  void send(std::shared_ptr<const std::string> text) override {
    if (queue_.size() > 0 && waiting > around_.options.limits.waiting) return close();
    queue_.push_back(std::move(text));
    if (queue_.size() == 1) write();
  }

  void close() override { beast::get_lowest_layer(stream_).close(); }

 private:
  void accepted() {
    id_ = around_.browsers.add(this->shared_from_this());
    if (id_ == 0) return end(websocket::close_code::try_again_later);
    stream_.text(true);
    around_.handler.opened(id_);
    read();
  }

  void read() {
    stream_.async_read(buffer_,
                       [self = this->shared_from_this()](beast::error_code error, std::size_t) {
                         if (!error) self->received();
                       });
  }

  void received() {
    if (!stream_.got_text()) return end(websocket::close_code::unknown_data);
    around_.handler.received(id_, beast::buffers_to_string(buffer_.data()));
    buffer_.consume(buffer_.size());
    read();
  }

  void write() {
    stream_.async_write(boost::asio::buffer(*queue_.front()),
                        [self = this->shared_from_this()](beast::error_code error, std::size_t) {
                          if (!error) self->written();
                        });
  }

  void written() {
    waiting -= queue_.front()->size();
    queue_.pop_front();
    if (!queue_.empty()) write();
  }

  void end(websocket::close_code code) {
    stream_.async_close(code, [self = this->shared_from_this()](beast::error_code) {});
  }

  websocket::stream<Stream> stream_;
  Surroundings& around_;
  BrowserId id_ = 0;
  beast::flat_buffer buffer_;
  std::deque<std::shared_ptr<const std::string>> queue_;
};

}  // namespace merker::hmi
