#include "serial/interface.h"

namespace merker::serial {

Interface::Interface(const Parameters& parameters)
    : parameters_(parameters), mailbox_(parameters.mailbox) {
  const std::uint8_t mask = parameters_.line.frame.mask();
  parameters_.procedure.mask = mask;
  parameters_.ascii.mask = mask;
  parameters_.ascii.twoWire = parameters_.line.mode == Mode::TwoWire;
  parameters_.ascii.discardInStop = parameters_.discardInStop;
  switch (parameters_.protocol) {
    case Protocol::Ascii:
      ascii_ = std::make_unique<Ascii>(parameters_.ascii, mailbox_);
      break;
    case Protocol::Procedure:
      procedure_ = std::make_unique<Procedure>(parameters_.procedure, mailbox_);
      break;
    case Protocol::ComputerLink:
      link_ = std::make_unique<Rk512>(LinkParameters{.procedure = parameters_.procedure});
      break;
  }
}

Driver& Interface::driver() const {
  if (ascii_) return *ascii_;
  if (procedure_) return *procedure_;
  return *link_;
}

void Interface::send(const Bytes& data, Instant now) {
  if (ascii_) ascii_->send(data, now);
  if (procedure_) procedure_->send(data, now);
}

void Interface::abort(Event why) {
  if (ascii_) ascii_->abort(why);
  if (procedure_) procedure_->abort(why);
  if (link_) link_->abort(why);
}

Outbox& Interface::outbox() {
  if (ascii_) return ascii_->outbox();
  return procedure_ ? procedure_->outbox() : link_->outbox();
}

std::optional<Mailbox::Entry> Interface::take() {
  auto entry = mailbox_.take();
  if (ascii_) ascii_->fetched();
  return entry;
}

void Interface::clear() {
  mailbox_.clear();
  if (ascii_) ascii_->fetched();
}

// With the reaction STOP nothing is stored while the CPU is in STOP (PTP-PARAM-04, PTP-OPEN-19).
void Interface::cpuStopped() {
  if (ascii_) return ascii_->cpuStopped();
  if (link_) return link_->cpuStopped();
  procedure_->abort(Event::Restarted);
  mailbox_.refuse(parameters_.discardInStop);
}

void Interface::cpuStarted() {
  if (ascii_) return ascii_->cpuStarted();
  if (link_) return link_->cpuStarted();
  mailbox_.start();
}

void Interface::interrupted(Instant at) {
  driver().interrupted(at);
  broken_ = true;
}

void Interface::restored(Instant at) {
  driver().restored(at);
  broken_ = false;
}

std::optional<bool> Interface::takeWireBreak() {
  if (!wireBreakPending()) return std::nullopt;
  shown_ = broken_;
  return broken_;
}

}  // namespace merker::serial
