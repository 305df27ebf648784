#include "serial/procedure.h"

#include <algorithm>

namespace merker::serial {

// In the order of State.
const std::array<Procedure::Reaction, 11> Procedure::kReactions = {{
    {&Procedure::inIdle, &Procedure::ignoreTimer},
    {&Procedure::inConnect, &Procedure::connectExpired},
    {&Procedure::inSending, &Procedure::ignoreTimer},
    {&Procedure::inDisturbed, &Procedure::disturbedExpired},
    {&Procedure::inClose, &Procedure::closeExpired},
    {&Procedure::inStray, &Procedure::strayExpired},
    {&Procedure::inWaitBuffer, &Procedure::waitBufferExpired},
    {&Procedure::inReceive, &Procedure::receiveExpired},
    {&Procedure::inGotDle, &Procedure::receiveExpired},
    {&Procedure::inGetBcc, &Procedure::receiveExpired},
    {&Procedure::inWaitRepeat, &Procedure::waitRepeatExpired},
}};

void Procedure::enter(State state, Instant timer) {
  state_ = state;
  timer_ = timer;
}

bool Procedure::sends() const { return state_ >= State::Connect && state_ <= State::Close; }

// Once ready it quiets its partner (PTP-P3964-07).
void Procedure::start(Instant) { control(kNak); }

void Procedure::received(const Character& character) {
  (this->*kReactions[static_cast<std::size_t>(state_)].received)(character);
}

// No repetition after a BREAK (PTP-P3964-26, -35).
void Procedure::interrupted(Instant at) {
  broken_ = true;
  pending_.clear();
  if (sends())
    endJob(Event::Break);
  else
    inbox_.report(Event::Break);
  idle(at);
}

void Procedure::restored(Instant) { broken_ = false; }

std::optional<std::uint8_t> Procedure::next(Instant) {
  if (!pending_.empty()) {
    leaving_ = pending_.front();
    pending_.erase(pending_.begin());
    return leaving_;
  }
  if (state_ != State::Sending || index_ == job_->block.size()) return std::nullopt;
  leaving_ = 0;
  return job_->block[index_++];
}

// The times begin when a character has left the line (PTP-P3964-09).
void Procedure::sent(Instant at) {
  if (state_ == State::Connect && leaving_ == kStx) timer_ = at + parameters_.acknowledgeDelay;
  if (state_ == State::Receive && leaving_ == kDle && timer_ == Instant::never())
    timer_ = at + parameters_.characterDelay;
  if (state_ == State::WaitRepeat && leaving_ == kNak) timer_ = at + parameters_.acknowledgeDelay;
  if (state_ == State::Sending && index_ == job_->block.size())
    enter(State::Close, at + parameters_.acknowledgeDelay);
  leaving_ = 0;
}

Instant Procedure::due() const {
  const bool waiting = state_ == State::Idle && job_;
  return waiting ? std::min(timer_, job_->ready) : timer_;
}

void Procedure::expire(Instant now) {
  if (timer_ <= now) (this->*kReactions[static_cast<std::size_t>(state_)].expired)(now);
  if (state_ == State::Idle) idle(now);
}

}  // namespace merker::serial
