#include "serial/blocks.h"

#include <algorithm>

namespace merker::serial {
namespace {

constexpr std::uint32_t kHighestOffset = 8190;

Place behind(const Place& place, std::size_t bytes) {
  return {place.block, place.offset + static_cast<std::uint32_t>(bytes)};
}

}  // namespace

Event checkPlace(const DataBlocks& blocks, const Place& place, std::size_t count) {
  const auto size = blocks.size(place.block);
  if (!size || place.offset > kHighestOffset) return Event::AreaNotPermitted;
  return place.offset + count > *size ? Event::NoAccess : Event::None;
}

// A job whose data were still being copied when the CPU stopped is aborted, too (PTP-SFBG-19).
void SendBlock::start() {
  state_.start();
  if (!running_ || handed_) return;
  running_ = false;
  state_.report(answerOf(Event::Restarted));
}

Answer SendBlock::call(const Control& control, const Place& source, std::int32_t length,
                       const DataBlocks& blocks, Instant now) {
  state_.call(control.instance, control.request, control.reset);
  if (!state_.starting()) {
    finish();
    if (state_.takeReset()) reset();
    if (state_.takeRequest()) accept(control, source, length, blocks);
    copy(blocks, now);
  }
  return state_.take().value_or(Answer{});
}

void SendBlock::finish() {
  if (!running_ || !handed_) return;
  const Event warning = interface_.outbox().takeWarning();
  if (warning != Event::None) state_.report(answerOf(warning), 0);
  if (const auto end = interface_.outbox().takeEnd()) {
    running_ = false;
    state_.report(answerOf(*end), 0);
  }
}

// Without a job it shows DONE (PTP-OPEN-07).
void SendBlock::reset() {
  state_.report(running_ ? answerOf(Event::Reset) : kDone, CallState::kReset);
  if (running_ && handed_) {
    interface_.abort(Event::Reset);
    interface_.outbox().takeEnd();
  }
  running_ = false;
}

void SendBlock::accept(const Control& control, const Place& source, std::int32_t length,
                       const DataBlocks& blocks) {
  Event event = Event::None;
  if (!control.permitted)
    event = Event::NotPermitted;
  else if (running_)
    event = Event::StillRunning;
  else if (length < 1 || length > static_cast<std::int32_t>(kLongest))
    event = Event::WrongLength;
  else
    event = checkPlace(blocks, source, static_cast<std::size_t>(length));
  if (event != Event::None) return state_.report(answerOf(event));
  running_ = true;
  handed_ = false;
  source_ = source;
  length_ = static_cast<std::size_t>(length);
  copied_.clear();
}

// A portion in each call; the line begins when all is there (PTP-SFB60-09).
void SendBlock::copy(const DataBlocks& blocks, Instant now) {
  if (!running_ || handed_) return;
  const Place from = behind(source_, copied_.size());
  const std::size_t count = std::min(kPortion, length_ - copied_.size());
  const Event event = checkPlace(blocks, from, count);
  if (event != Event::None) {
    running_ = false;
    return state_.report(answerOf(event));
  }
  const Bytes part = blocks.read(from, count);
  copied_.insert(copied_.end(), part.begin(), part.end());
  if (copied_.size() < length_) return;
  handed_ = true;
  interface_.send(copied_, now);
}

void ReceiveBlock::start() {
  state_.start();
  if (!telegram_) return;
  telegram_.reset();
  state_.report(answerOf(Event::Restarted));
}

ReceiveBlock::Received ReceiveBlock::call(const Control& control, const Place& target,
                                          DataBlocks& blocks) {
  state_.call(control.instance, false, control.reset);
  if (!state_.starting()) {
    if (state_.takeReset())
      stop(CallState::kReset);
    else if (!control.request && telegram_)
      stop(CallState::kNext);
    else if (control.request && !control.reset && !state_.reporting())
      control.permitted ? fetch(target, blocks) : state_.report(answerOf(Event::NotPermitted));
  }
  const Answer answer = state_.take().value_or(Answer{});
  if (answer.done || answer.error) length_ = answer.done ? done_ : 0;
  return {answer, length_};
}

// The telegram that is being copied is lost (PTP-SFB61-01, -02).
void ReceiveBlock::stop(unsigned calls) {
  state_.report(telegram_ ? answerOf(Event::Reset) : kDone, calls);
  telegram_.reset();
  done_ = 0;
}

void ReceiveBlock::fetch(const Place& target, DataBlocks& blocks) {
  if (telegram_) return copy(blocks);
  auto entry = interface_.take();
  if (!entry) return;
  Event event = entry->event;
  if (event == Event::None) event = checkPlace(blocks, target, entry->telegram.size());
  if (event != Event::None) return state_.report(answerOf(event));
  telegram_ = std::move(entry->telegram);
  target_ = target;
  copied_ = 0;
  copy(blocks);
}

void ReceiveBlock::copy(DataBlocks& blocks) {
  const std::size_t count = std::min(kPortion, telegram_->size() - copied_);
  const Place to = behind(target_, copied_);
  const Event event = checkPlace(blocks, to, count);
  if (event != Event::None) {
    telegram_.reset();
    return state_.report(answerOf(event));
  }
  blocks.write(to, std::span(*telegram_).subspan(copied_, count));
  copied_ += count;
  if (copied_ < telegram_->size()) return;
  done_ = static_cast<std::int32_t>(copied_);
  telegram_.reset();
  state_.report(kDone);
}

// The telegram that is just arriving stays (PTP-SFB62-02).
Answer ClearBlock::call(const Control& control) {
  state_.call(control.instance, control.request, control.reset);
  if (!state_.starting()) {
    if (state_.takeReset()) state_.report(kDone, CallState::kReset);
    if (state_.takeRequest()) {
      if (control.permitted) interface_.clear();
      state_.report(control.permitted ? kDone : answerOf(Event::NotPermitted));
    }
  }
  return state_.take().value_or(Answer{});
}

}  // namespace merker::serial
