// A connection to a PageServer: request after request.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <list>
#include <optional>
#include <utility>

#include "server/answer.h"
#include "server/sessions.h"
#include "server/write_answer.h"

namespace merker::hmi {

class PageSession : public Unfinished, public std::enable_shared_from_this<PageSession> {
 public:
  PageSession(boost::asio::ip::tcp::socket socket, std::shared_ptr<PageSurroundings> around)
      : stream_(std::move(socket), nullptr),
        patience_(stream_.get_executor()),
        around_(std::move(around)) {
    around_->sessions.push_back(this);
    around_->pages->opened();
  }
  ~PageSession() override {
    around_->sessions.remove(this);
    if (around_->pages != nullptr) around_->pages->closed();
  }
  PageSession(const PageSession&) = delete;
  PageSession& operator=(const PageSession&) = delete;

  void giveUp() override {
    patience_.cancel();
    beast::get_lowest_layer(stream_).close();
  }

  void read() {
    constexpr std::size_t kBody = 1024;  // no request has one
    parser_.emplace();
    parser_->header_limit(around_->limits.header);
    parser_->body_limit(kBody);
    limitTime(std::exchange(first_, false) ? around_->limits.request : around_->limits.idle);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       self->received(error);
                     });
  }

 private:
  void limitTime(unsigned seconds) {
    beast::get_lowest_layer(stream_).expires_after(std::chrono::seconds(seconds));
  }

  void received(beast::error_code error) {
    if (error) {
      const http::status unread = refusal(error);
      return unread == http::status::ok ? void() : end(unread);
    }
    if (around_->pages == nullptr) return;
    const Request& request = parser_->get();
    const http::status wrong = refusal(request, around_->guard);
    if (wrong != http::status::ok) return write(refuse(request, wrong));
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return write(refuse(request, http::status::method_not_allowed));
    ask();
  }

  // The PLC answers at the end of its cycle: one that never ends keeps nobody waiting.
  void ask() {
    waits_ = true;
    patience_.expires_after(std::chrono::seconds(around_->limits.idle));
    patience_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (!error && std::exchange(self->waits_, false))
        self->write(refuse(self->parser_->get(), http::status::gateway_timeout));
    });
    const auto target = parser_->get().target();
    around_->pages->page(std::string(target.data(), target.size()),
                         [weak = weak_from_this(), turn = ++turn_](Page page) {
                           const auto self = weak.lock();
                           if (self && self->turn_ == turn) self->show(std::move(page));
                         });
  }
  void show(Page page) {
    if (!std::exchange(waits_, false)) return;
    patience_.cancel();
    page_ = std::move(page);
    write(pageAnswer(parser_->get(), page_));
  }

  void end(http::status status) {
    Request request;
    request.version(11);
    request.keep_alive(false);
    write(refuse(request, status));
  }

  void write(Answer answer) {
    answer_ = std::move(answer);
    limitTime(around_->limits.idle);
    writeAnswer(stream_, answer_, [self = shared_from_this()] { self->read(); });
  }

  Stream stream_;
  boost::asio::steady_timer patience_;
  std::shared_ptr<PageSurroundings> around_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Page page_;
  Answer answer_;
  std::uint64_t turn_ = 0;  // of the request that is answered
  bool first_ = true, waits_ = false;
};

}  // namespace merker::hmi
