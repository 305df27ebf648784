#include "s7_connection.h"

#include <fmt/format.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

namespace merker::app {
namespace {

// Of answers that wait for the client; beyond that nothing more is read from it.
constexpr std::size_t kMostAnswers = 64 << 10;
// And what the PLC says unasked waits in its own place then.
constexpr std::size_t kMostIndicated = 16 << 10;

constexpr std::chrono::seconds kClientLimits[] = {
    std::chrono::seconds(5),   // Request: of the transport connection
    std::chrono::seconds(5),   // Setup
    std::chrono::seconds(5),   // RestOfMessage
    std::chrono::seconds(20),  // Reading what it has asked for
    std::chrono::seconds(5),   // Answer to what this side has asked
};

// It asks one that has been silent for 30 s, three times at intervals of 5 s.
constexpr std::pair<int, int> kKeepAlive[] = {
    {TCP_KEEPIDLE, 30}, {TCP_KEEPINTVL, 5}, {TCP_KEEPCNT, 3}};

constexpr const char* kResourceNames[] = {"PG", "OP", "other"};  // of Resource

}  // namespace

std::string partnerOf(const S7Connection::Socket& socket) {
  boost::system::error_code gone;
  const auto endpoint = socket.remote_endpoint(gone);
  if (gone) return "?";
  const bool six = endpoint.address().is_v6();
  return fmt::format("{}{}{}:{}", six ? "[" : "", endpoint.address().to_string(), six ? "]" : "",
                     endpoint.port());
}

std::string addressOf(const S7Connection::Socket& socket) {
  boost::system::error_code gone;
  const auto endpoint = socket.remote_endpoint(gone);
  return gone ? "?" : endpoint.address().to_string();
}

std::optional<workbench::S7ClientRow> S7Connection::row(Clock::time_point now) const {
  if (!session_ || configured_) return std::nullopt;
  return workbench::S7ClientRow{
      .partner = partner_,
      .kind = kResourceNames[static_cast<std::size_t>(resource_)],
      .pdu = session_->pdu(),
      .seconds = std::chrono::duration_cast<std::chrono::seconds>(now - since_).count(),
      .requests = requests_,
      .received = received_,
      .sent = sent_,
      .lost = session_->outlet()->lost()};
}

S7Connection::S7Connection(Socket socket, S7Surroundings& around)
    : socket_(std::move(socket)), around_(around), transport_(iso::Transport::Side::Called) {
  prepare();
}

void S7Connection::prepare() {
  boost::system::error_code ignored;
  partner_ = partnerOf(socket_);
  address_ = addressOf(socket_);
  socket_.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  // Who has vanished without a word is found by the operating system.
  socket_.set_option(boost::asio::socket_base::keep_alive(true), ignored);
  for (const auto& [option, value] : kKeepAlive)
    setsockopt(socket_.native_handle(), IPPROTO_TCP, option, &value, sizeof value);
}

S7Connection::~S7Connection() { close(); }

void S7Connection::begin(iso::View sent, S7WayOpen way) {
  expect(true);
  way_ = std::move(way);
  if (way_ == nullptr) return read();
  received_ += sent.size();
  transport_.feed(sent);
  pump();
}

void S7Connection::close() {
  if (closed_) return;
  closed_ = true;
  boost::system::error_code ignored;
  socket_.close(ignored);
  if (attached_) partner().detach();
  if (!session_) return;
  session_->end();
  session_.reset();
  if (!configured_) around_.resources.release(resource_);
  around_.exchange.inUse(around_.resources.counts());
  around_.exchange.closed();
}

// Who does not answer what this side has asked (a piece of a block) loses that, and stays; a
// partner that does not answer has gone.
void S7Connection::breakOffLate() {
  if (expected_ != Expected::Answer || attached_)
    return breakOff(expected_ == Expected::Reading ? S7Why::ReadsNothing : S7Why::TooLate);
  session_->giveUp();
  expect(true);
}

void S7Connection::breakOff(S7Why why) {
  note(why);
  close();
}

S7Connection::Expected S7Connection::expected() const {
  if (!sending_.empty()) return Expected::Reading;
  if (!transport_.open()) return Expected::Request;
  if (session_ && !session_->isSetUp()) return Expected::Setup;
  // Bytes that wait because it is this side that is busy are no fault of the client.
  if (reading_ && transport_.unfinished()) return Expected::RestOfMessage;
  const bool asks = session_ && (session_->asks() || (attached_ && partnerAsks()));
  return asks ? Expected::Answer : Expected::Nothing;
}

// `moved`: what was expected has come, at least a part that counts.
void S7Connection::expect(bool moved) {
  const Expected now = expected();
  if (now == expected_ && !moved) return;
  expected_ = now;
  due_ = now == Expected::Nothing ? Clock::time_point::max()
                                  : Clock::now() + kClientLimits[static_cast<std::size_t>(now)];
}

void S7Connection::read() {
  if (reading_ || closed_) return;
  reading_ = true;
  socket_.async_read_some(
      boost::asio::buffer(buffer_),
      [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
        self->reading_ = false;
        if (error) return self->close();
        self->received(count);
      });
}

void S7Connection::received(std::size_t count) {
  if (closed_) return;
  received_ += count;
  const iso::View bytes = iso::View(buffer_).first(count);
  if (around_.passOn && !transport_.open()) head_.insert(head_.end(), bytes.begin(), bytes.end());
  transport_.feed(bytes);
  pump();
}

// As long as the session takes more and the client reads its answers. What is left stays where it
// is; nothing more is read meanwhile.
void S7Connection::pump() {
  if (pumping_ || closed_ || ending_) return;
  pumping_ = true;
  bool moved = false, all = false;
  while (!closed_ && !ending_ && out_.size() < kMostAnswers && !(session_ && session_->busy())) {
    auto event = transport_.next();
    all = !event;
    if (all) break;
    moved = true;
    handle(*event);
  }
  pumping_ = false;
  flush();
  if (all && !closed_) read();
  if (!closed_) expect(moved);
}

void S7Connection::handle(iso::Event& event) {
  using Kind = iso::Event::Kind;
  switch (event.kind) {
    case Kind::Requested:
      return requested(event.parameters);
    case Kind::Message:
      ++around_.incidents.counts.requests;
      ++requests_;
      if (hear(event.message)) return;
      note(S7Why::NoS7);
      ending_ = true;  // what has been answered is sent
      return;
    case Kind::Violated:
      note(S7Why::WrongTransport);
      out_.insert(out_.end(), event.answer.begin(), event.answer.end());
      ending_ = true;
      return;
    case Kind::Confirmed:
      return confirmed();
    case Kind::Disconnected:
      out_.insert(out_.end(), event.answer.begin(), event.answer.end());
      ending_ = true;
      return;
  }
}

void S7Connection::refuse(iso::Reason reason, S7Why why) {
  note(why);
  out_ = transport_.refuse(reason);
  ending_ = true;
}

void S7Connection::requested(const iso::ConnectParameters& parameters) {
  const S7Whose whose =
      around_.passOn ? around_.passOn(socket_, parameters.called, head_) : S7Whose::Own;
  if (whose == S7Whose::NoWay) return refuse(iso::Reason::UnknownAddress, S7Why::NoWay);
  if (whose == S7Whose::Passed) {
    closed_ = true;  // its socket is another one's
    return;
  }
  head_.clear();
  resource_ = served::resourceOf(parameters.called);
  if (takesConfigured(parameters)) return serve();
  if (around_.parameters.strictSlot && way_ == nullptr && !served::namesTheCpu(parameters.called))
    return refuse(iso::Reason::UnknownAddress, S7Why::OtherSlot);
  while (!around_.resources.take(resource_))
    if (!around_.makeRoom(resource_)) return refuse(iso::Reason::Congestion, S7Why::NoResource);
  serve();
}

// It has been called, or has called and was confirmed.
void S7Connection::serve() {
  since_ = Clock::now();
  ++around_.incidents.counts.connections;
  around_.exchange.inUse(around_.resources.counts());
  around_.exchange.opened();
  session_ = std::make_shared<s7comm::Session>(
      around_.exchange,
      [weak = weak_from_this()](const iso::Bytes& pdu) {
        if (const auto self = weak.lock()) self->send(pdu);
      },
      s7comm::Offer{.pdu = around_.parameters.pdu});
  session_->whenReady([weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->pump();
  });
  session_->guardBy(guard());
  session_->roomBy([this] { return !closed_ && out_.size() < kMostIndicated; });
  if (!transport_.open()) {
    const iso::Bytes answer = transport_.confirm();
    out_.insert(out_.end(), answer.begin(), answer.end());
  }
  if (configured_) attachPartner();
}

s7comm::Session::Guard S7Connection::guard() {
  const auto weak = weak_from_this();
  return {.refused =
              [weak](s7comm::Error error) {
                if (const auto self = weak.lock()) self->denied(error);
              },
          .turn =
              [weak](const std::function<void(bool)>& look) {
                if (const auto self = weak.lock()) self->whenItsTurn(look);
              },
          .wrong =
              [weak] {
                if (const auto self = weak.lock())
                  self->around_.passwords.wrong(self->address_, Clock::now());
              }};
}

void S7Connection::denied(s7comm::Error error) {
  using s7comm::Error;
  if (session_ && !session_->isSetUp()) return note(S7Why::WrongSetup);
  if (error == Error::NeedsPassword || error == Error::TestProtected) note(S7Why::Protected);
  if (error == Error::WrongPassword) note(S7Why::WrongPassword);
}

// Nothing else of this client is served meanwhile.
void S7Connection::whenItsTurn(const std::function<void(bool)>& look) {
  const auto wait = around_.passwords.turn(address_, Clock::now());
  if (!wait || *wait == Clock::duration::zero()) return look(wait.has_value());
  const auto timer = std::make_shared<boost::asio::steady_timer>(socket_.get_executor(), *wait);
  timer->async_wait([timer, look](boost::system::error_code) { look(true); });
}

void S7Connection::send(iso::View pdu) {
  if (closed_) return;
  transport_.write(out_, pdu);
  if (!pumping_) flush();
}

void S7Connection::flush() {
  if (closed_ || !sending_.empty()) return;
  if (out_.empty()) {
    if (ending_) close();
    return;
  }
  sending_.swap(out_);
  sent_ += sending_.size();
  boost::asio::async_write(
      socket_, boost::asio::buffer(sending_),
      [self = shared_from_this()](boost::system::error_code error, std::size_t) {
        if (error) return self->close();
        self->sent();
      });
  expect(true);
}

void S7Connection::sent() {
  sending_.clear();
  if (session_) session_->deliver();
  flush();
  if (closed_) return;
  expect(true);
  pump();
}

}  // namespace merker::app
