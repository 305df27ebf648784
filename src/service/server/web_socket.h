// One browser: texts in both directions, over TCP or TLS.
#pragma once

#include <poll.h>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <utility>

#include "server/answer.h"
#include "server/sessions.h"
#include "server/stream.h"

namespace merker::hmi {

namespace websocket = boost::beast::websocket;

class WebSocket : public Connection,
                  public Unfinished,
                  public std::enable_shared_from_this<WebSocket> {
 public:
  WebSocket(Stream stream, Surroundings& around)
      : stream_(std::move(stream)), around_(around), patience_(stream_.get_executor()) {
    ++around_.connections;
    around_.unfinished.push_back(this);
  }
  ~WebSocket() override {
    --around_.connections;
    around_.unfinished.remove(this);
    if (id_ == 0) return;
    around_.browsers.remove(id_);
    around_.handler.closed(id_);
  }
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  void accept(const Request& request) {
    beast::get_lowest_layer(stream_).expires_never();
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.handshake_timeout = std::chrono::seconds(around_.options.limits.request);
    stream_.set_option(timeout);
    stream_.read_message_max(around_.options.limits.message);
    stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (!error) self->accepted();
    });
  }

  void send(std::shared_ptr<const std::string> text) override {
    if (queue_.size() > 0 && *waiting > around_.options.limits.waiting) return close();
    queue_.push_back(std::move(text));
    if (queue_.size() == 1) write();
  }

  void resume() override {
    if (!std::exchange(paused_, false)) return;
    patience_.cancel();
    read();
  }

  void close() override { beast::get_lowest_layer(stream_).close(); }
  void giveUp() override { close(); }

 private:
  void accepted() {
    id_ = around_.browsers.add(shared_from_this());
    if (id_ == 0) return end(websocket::close_code::try_again_later);
    around_.unfinished.remove(this);
    stream_.text(true);
    around_.handler.opened(id_);
    read();
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      error ? self->close() : self->received();
    });
  }

  void received() {
    if (!stream_.got_text()) return end(websocket::close_code::unknown_data);
    std::string text = beast::buffers_to_string(buffer_.data());
    buffer_ = beast::flat_buffer();  // a long message does not keep its memory
    if (around_.handler.received(id_, std::move(text))) return read();
    paused_ = true;
    waitPaused();
  }

  // Nothing is read meanwhile: whether the browser has gone shows nowhere else.
  void waitPaused() {
    constexpr auto kBetweenLooks = std::chrono::milliseconds(200);
    patience_.expires_after(kBetweenLooks);
    patience_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (error || !self->paused_) return;
      self->hasGone() ? self->close() : self->waitPaused();
    });
  }

  bool hasGone() {
    auto& socket = beast::get_lowest_layer(stream_).socket();
    if (!socket.is_open()) return true;
    pollfd look{socket.native_handle(), POLLRDHUP, 0};
    return ::poll(&look, 1, 0) > 0 && (look.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
  }

  void write() {
    stream_.async_write(boost::asio::buffer(*queue_.front()),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          error ? self->close() : self->written();
                        });
  }

  void written() {
    *waiting -= queue_.front()->size();
    queue_.pop_front();
    if (!queue_.empty()) write();
  }

  void end(websocket::close_code code) {
    stream_.async_close(code, [self = shared_from_this()](beast::error_code) {});
  }

  websocket::stream<Stream> stream_;
  Surroundings& around_;
  BrowserId id_ = 0;
  bool paused_ = false;
  boost::asio::steady_timer patience_;
  beast::flat_buffer buffer_;
  std::deque<std::shared_ptr<const std::string>> queue_;
};

}  // namespace merker::hmi
