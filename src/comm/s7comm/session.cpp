#include "s7comm/session.h"

#include <utility>

#include "s7comm/services.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

// What the first PDU of a connection may have.
constexpr std::uint16_t kBeforeSetup = 240;

}  // namespace

Session::Session(Plc& plc, Send send, Offer offer)
    : plc_(plc), send_(std::move(send)), offer_(offer), pdu_(kBeforeSetup) {
  outlet_->deliverBy([this] { deliver(); });
}

Session::~Session() { outlet_->close(); }

void Session::agree(std::uint16_t pdu, std::uint16_t jobs) {
  pdu_ = pdu;
  jobs_ = jobs;
  setUp_ = true;
  outlet_->setRoom(pdu_ - kUserdataOverhead);
}

bool Session::receive(View bytes) {
  inside_ = true;
  const bool good = take(bytes);
  inside_ = false;
  return good;
}

bool Session::take(View bytes) {
  const auto pdu = readPdu(bytes);
  if (!pdu) return false;
  if (pdu->type == PduType::Acknowledge || pdu->type == PduType::Answer) return hear(*pdu), true;
  Job job{.session = shared_from_this(),
          .type = pdu->type,
          .reference = pdu->reference,
          .function = pdu->parameters.empty() ? std::uint8_t{0} : pdu->parameters[0],
          .parameters = pdu->parameters,
          .data = pdu->data};
  constexpr static Service kUserdata{0, "userdata", true, false, serveUserdata};
  const Service* const service =
      pdu->type == PduType::Userdata ? &kUserdata : findService(job.function);
  Error wrong = Error::None;
  if (service == nullptr || (!setUp_ && !service->beforeSetup)) wrong = Error::FunctionNotAvailable;
  if (bytes.size() > pdu_ || pdu->parameters.empty()) wrong = Error::WrongPduSize;
  if (waiting_ > 0 && (wrong != Error::None || service->waits))
    held_.assign(bytes.begin(), bytes.end());
  else if (wrong != Error::None)
    job.refuse(wrong);
  else
    service->serve(job);
  return true;
}

// One question at a time. A reference that this side has not used is of a recorded conversation,
// whose PLC had others: the function says what it is about.
bool Session::isAnswer(const Pdu& pdu) const {
  if (heard_ == nullptr || pdu.reference == asked_) return heard_ != nullptr;
  const View p = pdu.parameters;
  return pdu.reference > asked_ && !p.empty() && p[0] == askedFunction_;
}

// An answer to nothing is nothing.
void Session::hear(const Pdu& answer) {
  if (!isAnswer(answer)) return;
  const Heard heard = std::exchange(heard_, nullptr);
  heard(Job{.session = shared_from_this()}, answer);
}

void Session::ask(View parameters, Heard heard) {
  heard_ = heard;
  askedFunction_ = parameters[0];
  send_(writePdu({.type = PduType::Job, .reference = ++asked_, .parameters = parameters}));
}

void Session::giveUp() {
  heard_ = nullptr;
  download_ = {};
}

void Session::answered() {
  --waiting_;
  if (inside_) return;
  if (waiting_ == 0 && !held_.empty()) {
    const Bytes held = std::exchange(held_, {});
    take(held);
  }
  if (!busy() && ready_) ready_();
}

}  // namespace merker::s7comm
