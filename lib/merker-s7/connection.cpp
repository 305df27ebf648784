#include "connection.h"

#include <array>
#include <chrono>

#include "merker_s7.h"
#include "s7comm/request.h"

namespace merker::s7client {
namespace {

// Kind of resource, then rack * 20h + slot (ecosystem.md 1.1).
iso::Bytes tsap(unsigned resource, unsigned place) {
  return {static_cast<std::uint8_t>(resource), static_cast<std::uint8_t>(place)};
}

constexpr std::uint8_t kOneKibibyte = 10;  // 2^n octets of a TPDU

}  // namespace

int Connection::open(const Settings& settings) {
  close();
  settings_ = settings;
  transport_ = iso::Transport(iso::Transport::Side::Calling);
  int error = socket_.connect(settings.address, settings.port, settings.connectMilliseconds);
  if (error == 0) error = call();
  if (error == 0) error = setUp();
  if (error != 0) close();
  return error;
}

void Connection::close() {
  if (socket_.isOpen() && transport_.open())
    (void)socket_.send(transport_.disconnect(iso::Reason::Normal), settings_.sendMilliseconds);
  socket_.close();
}

int Connection::call() {
  const unsigned place = static_cast<unsigned>(settings_.rack) * 0x20 + settings_.slot;
  const iso::Bytes request = transport_.request(
      {.sizeCode = kOneKibibyte, .calling = tsap(1, 0), .called = tsap(settings_.type, place)});
  if (const int error = socket_.send(request, settings_.sendMilliseconds)) return error;
  iso::Event event;
  if (const int error = nextEvent(event)) return error;
  return event.kind == iso::Event::Kind::Confirmed ? 0 : errIsoConnect;
}

int Connection::setUp() {
  const std::uint16_t reference = nextReference();
  s7comm::Pdu answer;
  const auto request = s7comm::setupRequest(
      reference, {.pdu = static_cast<std::uint16_t>(settings_.pdu), .jobs = 1});
  if (const int error = exchangeOpen(request, reference, answer)) return error;
  const auto offer = s7comm::setupAnswer(answer);
  constexpr std::uint16_t kLeast = 32;  // less holds no variable
  if (!offer || offer->pdu < kLeast) return errCliNegotiatingPDU;
  pdu_ = offer->pdu;
  return 0;
}

int Connection::send(s7comm::View message) {
  iso::Bytes bytes;
  transport_.write(bytes, message);
  return socket_.send(bytes, settings_.sendMilliseconds);
}

// The time limit is that of the whole answer, not of each of its bytes.
int Connection::nextEvent(iso::Event& event) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::milliseconds(settings_.receiveMilliseconds);
  for (;;) {
    if (auto next = transport_.next()) {
      event = std::move(*next);
      return 0;
    }
    std::array<std::uint8_t, 2048> bytes;
    std::size_t count = 0;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left < 0) return errTCPReceiveTimeout;
    if (const int error = socket_.receive(bytes, static_cast<int>(left), count)) return error;
    transport_.feed({bytes.data(), count});
  }
}

// It lies in the connection until the next one.
int Connection::nextPdu(s7comm::Pdu& pdu) {
  iso::Event event;
  if (const int error = nextEvent(event)) return error;
  if (event.kind != iso::Event::Kind::Message)
    return event.kind == iso::Event::Kind::Disconnected ? errTCPConnectionReset : errIsoInvalidPDU;
  message_ = std::move(event.message);
  const auto read = s7comm::readPdu(message_);
  if (!read) return errIsoInvalidPDU;
  pdu = *read;
  return 0;
}

int Connection::exchangeOpen(s7comm::View request, std::uint16_t reference, s7comm::Pdu& answer) {
  if (const int error = send(request)) return error;
  do {
    if (const int error = nextPdu(answer)) return error;
  } while (answer.reference != reference || answer.type == s7comm::PduType::Job);
  return 0;
}

int Connection::heard(s7comm::Pdu& pdu) {
  if (!isOpen()) return errTCPNotConnected;
  const int error = nextPdu(pdu);
  if (error != 0) close();
  return error;
}

int Connection::reply(s7comm::View answer) {
  const int error = isOpen() ? send(answer) : static_cast<int>(errTCPNotConnected);
  if (error != 0) close();
  return error;
}

// After an error of the connection nobody knows what comes next: it is closed.
int Connection::exchange(s7comm::View request, std::uint16_t reference, s7comm::Pdu& answer) {
  if (!isOpen()) return errTCPNotConnected;
  const int error = exchangeOpen(request, reference, answer);
  if (error != 0) close();
  return error;
}

}  // namespace merker::s7client
