// One HTTP connection, over TCP or TLS: request after request, until it becomes a WebSocket.
#pragma once

#include <optional>
#include <utility>

#include "server/web_socket.h"
#include "server/write_answer.h"

namespace merker::hmi {

class HttpSession : public Unfinished, public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(Stream stream, Surroundings& around) : stream_(std::move(stream)), around_(around) {
    ++around_.connections;
    around_.unfinished.push_back(this);
  }
  ~HttpSession() override {
    --around_.connections;
    around_.unfinished.remove(this);
  }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  Stream& stream() { return stream_; }
  const Limits& limits() const { return around_.options.limits; }
  void limitTime(unsigned seconds) {
    beast::get_lowest_layer(stream_).expires_after(std::chrono::seconds(seconds));
  }
  void giveUp() override { beast::get_lowest_layer(stream_).close(); }

  void read() {
    constexpr std::size_t kBody = 1024;  // no request has one
    parser_.emplace();
    parser_->header_limit(around_.options.limits.header);
    parser_->body_limit(kBody);
    limitTime(std::exchange(first_, false) ? limits().request : limits().idle);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       self->received(error);
                     });
  }

 private:
  void received(beast::error_code error) {
    if (error) {
      const http::status wrong = refusal(error);
      return wrong == http::status::ok ? void() : answerAndEnd(wrong);
    }
    const Request& request = parser_->get();
    if (asksForWebSocket(request)) return upgrade();
    answer_ = answer(request, around_.guard, around_.options.assets);
    write();
  }

  void upgrade() {
    const Request& request = parser_->get();
    http::status status = refusal(request, around_.guard);
    const std::string_view target(request.target().data(), request.target().size());
    if (status == http::status::ok && !around_.guard.token(target))
      status = http::status::unauthorized;
    if (status != http::status::ok) {
      answer_ = refuse(request, status);
      return write();
    }
    std::make_shared<WebSocket>(std::move(stream_), around_)->accept(request);
  }

  void answerAndEnd(http::status status) {
    Request request;
    request.version(11);
    request.keep_alive(false);
    answer_ = refuse(request, status);
    write();
  }

  void write() {
    limitTime(limits().idle);
    writeAnswer(stream_, answer_, [self = shared_from_this()] { self->read(); });
  }

  Stream stream_;
  Surroundings& around_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Answer answer_;
  bool first_ = true;
};

}  // namespace merker::hmi
