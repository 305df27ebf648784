// The receiving half of the procedure 3964(R): R1 to R23 of PTP-P3964-29 to -51.
#include <utility>

#include "serial/procedure.h"

namespace merker::serial {
namespace {

constexpr Duration kBufferWait = Duration::milliseconds(400);  // PTP-P3964-30
constexpr Duration kBufferLook = Duration::milliseconds(50);

}  // namespace

// A job that waited begins (S1, S7, S18); during a BREAK it cannot (S16).
void Procedure::idle(Instant now) {
  enter(State::Idle);
  if (!job_ || job_->ready > now) return;
  if (broken_) return endJob(Event::Break);
  job_->setup = 1;
  job_->conflicts = 0;
  connect();
}

void Procedure::open() {
  reception_.data.clear();
  reception_.check = 0;
  reception_.bad = false;
  control(kDle);
  enter(State::Receive);  // ZVZ begins when DLE has left
}

// R1, R2: the partner's STX.
void Procedure::accept(Instant now) {
  if (inbox_.free()) return open();
  bufferUntil_ = now + kBufferWait;
  enter(State::WaitBuffer, now + kBufferLook);
}

void Procedure::note(Event event) {
  reception_.bad = true;
  if (reception_.first == Event::None) reception_.first = event;
}

void Procedure::inIdle(const Character& c) {
  if (c.is(kNak)) return;  // R4
  if (c.is(kStx)) {
    reception_ = {};
    return accept(c.at);
  }
  if (!c.good()) inbox_.report(Event::Transmission);       // R6
  enter(State::Stray, c.at + parameters_.characterDelay);  // R5
}

void Procedure::inStray(const Character& c) { timer_ = c.at + parameters_.characterDelay; }

void Procedure::strayExpired(Instant now) {
  control(kNak);
  inbox_.report(Event::Unexpected);
  idle(now);
}

void Procedure::inWaitBuffer(const Character&) {  // R3: it did not wait for DLE
  if (!reception_.shown) inbox_.report(Event::Unexpected);
  reception_.shown = true;
}

void Procedure::waitBufferExpired(Instant now) {
  if (inbox_.free()) return open();
  timer_ = now + kBufferLook;
  if (now < bufferUntil_) return;
  control(kNak);
  inbox_.report(Event::NoBuffer);
  idle(now);
}

// R22: what is too long is read to its end and refused.
void Procedure::store(std::uint8_t value) {
  if (reception_.data.size() == kLongest) return note(Event::ReceivedTooLong);
  reception_.data.push_back(value);
}

void Procedure::inReceive(const Character& c) {
  timer_ = c.at + parameters_.characterDelay;
  if (!c.good()) return note(Event::Transmission);  // R13
  reception_.check ^= c.value;
  if (c.value == kDle)
    state_ = State::GotDle;
  else
    store(c.value);
}

void Procedure::inGotDle(const Character& c) {
  timer_ = c.at + parameters_.characterDelay;
  state_ = State::Receive;
  if (!c.good()) return note(Event::Transmission);
  reception_.check ^= c.value;
  if (c.value == kDle) return store(kDle);
  if (c.value != kEtx) return note(Event::AfterDle);  // R12
  if (!parameters_.blockCheck) return finish(c.at);
  state_ = State::GetBcc;
}

void Procedure::inGetBcc(const Character& c) {
  if (!c.good())
    note(Event::Transmission);
  else if (c.value != reception_.check)
    note(Event::BlockCheck);
  finish(c.at);
}

void Procedure::finish(Instant now) {
  if (!reception_.bad && reception_.data.empty()) {
    inbox_.report(Event::Empty);  // R17
  } else if (!reception_.bad && inbox_.put(std::exchange(reception_.data, {})) != Event::None) {
    note(Event::NoBuffer);  // it would be lost: the partner has to repeat it
  }
  if (reception_.bad) {
    control(kNak);
    return fail(now);
  }
  control(kDle);
  idle(now);
}

// R18, behind the NAK: a repetition is expected, or the attempts are used up.
void Procedure::fail(Instant now) {
  const bool last = ++reception_.transmission > parameters_.transmissions;
  if (last) {
    if (!reception_.shown) inbox_.report(reception_.first);
    return idle(now);
  }
  if (reception_.transmission == 2 && !reception_.shown) inbox_.report(Event::RepetitionExpected);
  enter(State::WaitRepeat);  // the block wait time begins when NAK has left
}

// R14; between two partners of low priority it ends the job of this one (S8).
void Procedure::receiveExpired(Instant now) {
  const bool dleOnly = state_ == State::GotDle && reception_.data.empty();
  if (reception_.afterConflict && dleOnly && job_) endJob(Event::BothLow);
  note(Event::CharacterDelay);
  control(kNak);
  if (!reception_.shown) inbox_.report(Event::CharacterDelay);
  reception_.shown = true;
  fail(now);
}

void Procedure::inWaitRepeat(const Character& c) {
  if (c.is(kStx)) accept(c.at);  // R19; R21: anything else is discarded
}

void Procedure::waitRepeatExpired(Instant now) {
  if (!reception_.shown) inbox_.report(Event::NoRepetition);
  idle(now);
}

}  // namespace merker::serial
