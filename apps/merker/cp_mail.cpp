// An e-mail connection of a CP 343-1 IT: each job of AG_SEND is an e-mail, which is given to the
// mail server of the connection. One at a time.
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <ctime>
#include <functional>
#include <iostream>

#include "cp_sockets.h"
#include "itcp/smtp.h"

namespace merker::app {
namespace {

using boost::asio::ip::tcp;
using itcp::Smtp;
using system::SendReceive;
using MailClock = std::chrono::steady_clock;
using MailError = boost::system::error_code;

// For all of an e-mail: the mail server answers nobody so slowly.
constexpr std::chrono::seconds kToMail(30);

// "Fri, 27 Nov 2026 19:24:25 +0000"
std::string mailDate() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 40> text{};
  const std::size_t length =
      std::strftime(text.data(), text.size(), "%a, %d %b %Y %H:%M:%S +0000", &parts);
  return {text.data(), length};
}

// RFC 5321, 4.1.3
std::string literalOf(const boost::asio::ip::address& address) {
  return (address.is_v6() ? "[IPv6:" : "[") + address.to_string() + "]";
}

// One e-mail on its way.
class MailJob : public std::enable_shared_from_this<MailJob> {
 public:
  using Done = std::function<void(std::uint16_t result, const std::string& why)>;

  MailJob(boost::asio::io_context& context, itcp::Letter letter, Done done)
      : socket_(context), letter_(std::move(letter)), done_(std::move(done)) {}

  void begin(const tcp::endpoint& there) {
    socket_.async_connect(there, [self = shared_from_this()](MailError error) {
      if (!self->done_) return;
      if (error) return self->finish(SendReceive::kNoConnection, error.message());
      MailError ignored;
      self->smtp_.emplace(std::move(self->letter_),
                          literalOf(self->socket_.local_endpoint(ignored).address()));
      self->read();
    });
  }
  void look() {
    if (MailClock::now() >= due_) finish(SendReceive::kNotTaken, "no answer for too long");
  }
  void close() {
    done_ = {};
    MailError ignored;
    socket_.close(ignored);
  }

 private:
  void finish(std::uint16_t result, const std::string& why) {
    const Done done = std::exchange(done_, {});
    close();
    if (done) done(result, why);
  }
  void read() {
    socket_.async_read_some(boost::asio::buffer(buffer_),
                            [self = shared_from_this()](MailError error, std::size_t count) {
                              if (!self->done_) return;
                              error ? self->finish(SendReceive::kNotTaken, error.message())
                                    : self->received({self->buffer_.data(), count});
                            });
  }
  void received(std::string_view octets) {
    for (const char c : octets) {
      if (c != '\n') {
        if (c != '\r') line_ += c;
        continue;
      }
      out_ += smtp_->hear(line_);
      line_.clear();
    }
    if (line_.size() > Smtp::kLongestReply)
      return finish(SendReceive::kNotTaken, "a reply without an end");
    out_.empty() ? read() : write();
  }
  void write() {
    boost::asio::async_write(socket_, boost::asio::buffer(out_),
                             [self = shared_from_this()](MailError error, std::size_t) {
                               if (self->done_) self->written(error);
                             });
  }
  // The last word is QUIT; whether it arrives does not matter.
  void written(MailError error) {
    out_.clear();
    if (smtp_->state() == Smtp::State::Sent) return finish(SendReceive::kSent, {});
    if (smtp_->state() == Smtp::State::Refused)
      return finish(SendReceive::kNotTaken, "the mail server says: " + smtp_->reason());
    error ? finish(SendReceive::kNotTaken, error.message()) : read();
  }

  tcp::socket socket_;
  itcp::Letter letter_;
  Done done_;  // empty: it has ended
  std::optional<Smtp> smtp_;
  std::string line_, out_;
  std::array<char, 1024> buffer_{};
  MailClock::time_point due_ = MailClock::now() + kToMail;
};

class CpMail final : public CpSocket, public std::enable_shared_from_this<CpMail> {
 public:
  explicit CpMail(CpPlace place) : place_(std::move(place)) {}

  // The mail server is called for each e-mail: the connection itself is always there.
  void look() override {
    if (closed_) return;
    if (!std::exchange(up_, true)) place_.lines.connected(place_.i, true);
    if (const auto job = job_) job->look();
    move();
  }
  void move() override {
    if (job_ || closed_) return;
    const auto data = place_.lines.toSend(place_.i);
    if (!data) return;
    const auto mail = system::mailOf(*data);
    mail ? send(*mail) : place_.lines.ended(place_.i, SendReceive::kNotTaken);
  }
  void close() override {
    closed_ = true;
    if (const auto job = std::exchange(job_, {})) job->close();
    if (std::exchange(up_, false)) place_.lines.connected(place_.i, false);
  }

 private:
  void send(const system::MailData& mail) {
    const CpConnectionParameters& there = place_.parameters();
    job_ = std::make_shared<MailJob>(
        place_.context, itcp::letterOf(mail, there.sender, mailDate()),
        [weak = weak_from_this()](std::uint16_t result, const std::string& why) {
          if (const auto self = weak.lock()) self->sent(result, why);
        });
    job_->begin({boost::asio::ip::make_address(there.host), there.port});
  }
  void sent(std::uint16_t result, const std::string& why) {
    job_.reset();
    if (!why.empty() && why != why_)
      std::cerr << "merker: e-mail connection " << unsigned{place_.parameters().id}
                << " of the CP: " << why << '\n';
    why_ = why;
    place_.lines.ended(place_.i, result);
    move();
  }

  CpPlace place_;
  std::shared_ptr<MailJob> job_;
  std::string why_;  // the last e-mail was not taken
  bool up_ = false, closed_ = false;
};

}  // namespace

std::shared_ptr<CpSocket> mailsOf(const CpPlace& place) { return std::make_shared<CpMail>(place); }

}  // namespace merker::app
