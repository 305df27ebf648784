#include "serial/rk512.h"

#include <algorithm>
#include <utility>

namespace merker::serial {
namespace {

// RK 512 has its own times before a telegram, and always eight data bits.
ProcedureParameters below(ProcedureParameters parameters) {
  parameters.preparation = {};
  parameters.mask = 0xFF;
  return parameters;
}

}  // namespace

Rk512::Rk512(const LinkParameters& parameters)
    : parameters_(parameters), procedure_(below(parameters.procedure), *this) {}

void Rk512::received(const Character& character) {
  now_ = character.at;
  procedure_.received(character);
  pump(now_);
}

void Rk512::interrupted(Instant at) {
  now_ = at;
  procedure_.interrupted(at);
  pump(at);
}

Instant Rk512::due() const { return std::min({procedure_.due(), activeTimer_, passiveTimer_}); }

void Rk512::expire(Instant now) {
  now_ = now;
  if (procedure_.due() <= now) procedure_.expire(now);
  if (activeTimer_ <= now) {
    activeTimer_ = Instant::never();
    if (active_ == Active::Prepares)
      commandReady_ = true;
    else if (active_ == Active::Waits)
      reactionOverdue();
  }
  if (passiveTimer_ <= now) passiveExpired();
  pump(now);
}

// A reaction goes before a command of its own, but a command that is being sent is not taken back
// (PTP-RK512-30).
void Rk512::pump(Instant now) {
  const Event warning = procedure_.outbox().takeWarning();
  if (warning != Event::None && output_ == Output::CommandTelegram) outbox_.warn(warning);
  if (const auto end = procedure_.outbox().takeEnd()) {
    const Output was = std::exchange(output_, Output::Nothing);
    if (was == Output::CommandTelegram) commandSent(*end, now);
    if (was == Output::ReactionTelegram) reactionSent(*end, now);
  }
  if (procedure_.outbox().busy()) return;
  if (!replies_.empty()) {
    output_ = Output::ReactionTelegram;
    replyOfJob_ = replies_.front().ofJob;
    procedure_.send(replies_.front().telegram, now);
    replies_.pop_front();
  } else if (std::exchange(commandReady_, false)) {
    output_ = Output::CommandTelegram;
    active_ = Active::Sends;
    procedure_.send(command_, now);
  }
}

// Told apart by byte 3 (PTP-RK512-29).
Event Rk512::put(Bytes telegram) {
  if (isReaction(telegram))
    takeReaction(telegram);
  else
    takeCommand(telegram);
  return Event::None;
}

}  // namespace merker::serial
