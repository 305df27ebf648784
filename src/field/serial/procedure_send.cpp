// The sending half of the procedure 3964(R): S1 to S18 of PTP-P3964-11 to -28.
#include "serial/procedure.h"

namespace merker::serial {
namespace {

// What follows STX: data with doubled DLE, DLE ETX, and their exclusive or (PTP-P3964-02 to -05).
Bytes blockOf(const Bytes& data, const ProcedureParameters& parameters, std::size_t& closing) {
  Bytes block;
  for (const std::uint8_t byte : data) {
    const auto value = static_cast<std::uint8_t>(byte & parameters.mask);
    block.push_back(value);
    if (value == Procedure::kDle) block.push_back(value);
  }
  closing = block.size();
  block.push_back(Procedure::kDle);
  block.push_back(Procedure::kEtx);
  std::uint8_t check = 0;
  for (const std::uint8_t value : block) check ^= value;
  if (parameters.blockCheck) block.push_back(check);
  return block;
}

}  // namespace

void Procedure::send(const Bytes& data, Instant now) {
  outbox_.begin();
  job_ = Job();
  job_->block = blockOf(data, parameters_, job_->closing);
  job_->ready = now + parameters_.preparation.of(data.size());
}

// NAK quiets a partner that waits for the rest (PTP-P3964-27).
void Procedure::abort(Event why) {
  if (!job_) return;
  if (sends()) {
    pending_.clear();
    control(kNak);
    enter(State::Idle);
  }
  endJob(why);
}

void Procedure::endJob(Event event) {
  job_.reset();
  outbox_.end(event);
}

void Procedure::connect() {
  job_->conflict = false;
  control(kStx);
  enter(State::Connect);  // QVZ begins when STX has left
}

// S3, S4, S8: the next STX, until the attempts are used up. Both high: a conflict that lasted in
// each of them, and no error before (PTP-P3964-18, -53).
void Procedure::retrySetup(Event event) {
  if (job_->first == Event::None) job_->first = event;
  if (++job_->setup <= parameters_.setups) return connect();
  control(kNak);
  const bool bothHigh = job_->transmission == 1 && job_->conflicts >= parameters_.setups;
  enter(State::Idle);
  endJob(bothHigh ? Event::BothHigh : job_->first);
}

// S10, S11, S13, S14: the whole block once more, from STX. `quiet`: NAK was already sent.
void Procedure::retryBlock(Event event, bool quiet) {
  if (job_->first == Event::None) job_->first = event;
  if (++job_->transmission <= parameters_.transmissions) {
    if (job_->transmission == 2) outbox_.warn(Event::RepetitionSent);
    job_->setup = 1;
    job_->conflicts = 0;
    return connect();
  }
  if (!quiet) control(kNak);
  enter(State::Idle);
  endJob(job_->first);
}

// What comes before STX has left the line is not its answer, except the partner's own STX.
void Procedure::inConnect(const Character& c) {
  if (c.is(kStx)) {
    job_->conflict = true;
    if (parameters_.highPriority) return;  // S5
    reception_ = {};
    reception_.afterConflict = true;
    return accept(c.at);  // S6
  }
  if (timer_ == Instant::never()) return;
  if (!c.is(kDle)) return retrySetup(Event::SetupRefused);
  index_ = 0;
  enter(State::Sending);
}

void Procedure::inSending(const Character& c) {
  if (c.is(kNak)) return retryBlock(Event::RefusedWhileSending, false);
  if (c.is(kDle) && index_ > job_->closing) return retryBlock(Event::EndRefused, false);  // S15
  if (job_->first == Event::None) job_->first = Event::Disturbed;
  enter(State::Disturbed, c.at + parameters_.characterDelay);
}

void Procedure::inDisturbed(const Character& c) { timer_ = c.at + parameters_.characterDelay; }

void Procedure::inClose(const Character& c) {
  if (!c.is(kDle)) return retryBlock(Event::EndRefused, false);
  enter(State::Idle);
  endJob(Event::None);
}

void Procedure::connectExpired(Instant) {
  if (job_->conflict) ++job_->conflicts;
  retrySetup(Event::SetupTimeout);
}

void Procedure::disturbedExpired(Instant) {
  control(kNak);
  retryBlock(Event::Disturbed, true);
}

void Procedure::closeExpired(Instant) { retryBlock(Event::EndTimeout, false); }

}  // namespace merker::serial
