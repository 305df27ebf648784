#include "serial/link_blocks.h"

#include <algorithm>
#include <string_view>

namespace merker::serial {
namespace {

bool within(std::int32_t value, std::int32_t most) { return value >= 0 && value <= most; }

Event checkArea(const LinkRequest& r, bool fetch) {
  constexpr std::string_view kSent = "DX", kFetched = "DXMEAZT";
  if ((fetch ? kFetched : kSent).find(r.type) == std::string_view::npos) return Event::WrongType;
  const bool block = r.type == 'D' || r.type == 'X';
  if (block && !within(r.block, 255)) return Event::AreaNotPermitted;
  if (!within(r.offset, block ? 510 : 255)) return Event::AreaNotPermitted;
  return Event::None;
}

Event checkRequest(const LinkRequest& r, bool fetch) {
  if (r.length > static_cast<std::int32_t>(kLongest)) return Event::TooLong;
  if (r.length < 1) return Event::WrongLength;
  if (!within(r.cpu, 4)) return Event::WrongCpu;
  if (!within(r.flagByte, 255)) return Event::AreaNotPermitted;
  if (r.flagByte < 255 && !within(r.flagBit, 7)) return Event::WrongFlagBit;
  return checkArea(r, fetch);
}

}  // namespace

LinkRequestResult jobOf(const LinkRequest& r, bool fetch) {
  LinkRequestResult result{checkRequest(r, fetch), {}};
  if (result.event != Event::None) return result;
  LinkJob& job = result.job;
  job.fetch = fetch;
  job.type = r.type;
  job.block = static_cast<std::uint8_t>(job.inBlock() ? r.block : 0);
  job.offset = static_cast<std::uint16_t>(r.offset);
  job.length = static_cast<std::uint16_t>(r.length);
  job.cpu = static_cast<std::uint8_t>(r.cpu);
  if (r.flagByte < 255)
    job.flag = {static_cast<std::uint8_t>(r.flagByte), static_cast<std::uint8_t>(r.flagBit)};
  return result;
}

Answer LinkJobBlock::call(const Control& control, const LinkRequest& request, const Place& data,
                          DataBlocks& blocks, Instant now) {
  state_.call(control.instance, control.request, control.reset);
  if (!state_.starting()) {
    finish();
    if (state_.takeReset()) reset();
    if (state_.takeRequest()) accept(control, request, data, blocks, now);
    transfer(blocks, now);
  }
  return state_.take().value_or(Answer{});
}

void LinkJobBlock::finish() {
  if (!running_) return;
  const Event warning = interface_.outbox().takeWarning();
  if (warning != Event::None) state_.report(answerOf(warning), 0);
  if (const auto end = interface_.outbox().takeEnd()) {
    running_ = false;
    state_.report(answerOf(*end), 0);
  }
}

void LinkJobBlock::fail(Event event) {
  interface_.abort(event);
  interface_.outbox().takeEnd();
  running_ = false;
  state_.report(answerOf(event));
}

void LinkJobBlock::reset() {
  state_.report(running_ ? answerOf(Event::Reset) : kDone, CallState::kReset);
  if (!running_) return;
  interface_.abort(Event::Reset);
  interface_.outbox().takeEnd();
  running_ = false;
}

void LinkJobBlock::accept(const Control& control, const LinkRequest& request, const Place& data,
                          const DataBlocks& blocks, Instant now) {
  LinkRequestResult result;
  if (!control.permitted)
    result.event = Event::NotPermitted;
  else if (!interface_.outbox().free())
    result.event = Event::StillRunning;
  else
    result = jobOf(request, fetch_);
  if (result.event == Event::None) result.event = checkPlace(blocks, data, result.job.length);
  if (result.event != Event::None) return state_.report(answerOf(result.event));
  running_ = true;
  data_ = data;
  done_ = 0;
  interface_.link()->begin(result.job, now);
}

// The data of one telegram in a call (PTP-SFB63-11, PTP-SFB64-06).
void LinkJobBlock::transfer(DataBlocks& blocks, Instant now) {
  if (!running_) return;
  if (const auto part = interface_.link()->wanted()) {
    const Place from{data_.block, data_.offset + static_cast<std::uint32_t>(part->offset)};
    const Event event = checkPlace(blocks, from, part->count);
    if (event != Event::None) return fail(event);
    interface_.link()->supply(blocks.read(from, part->count), now);
  }
  if (const auto fetched = interface_.link()->takeFetched(now)) {
    const Place to{data_.block, data_.offset + static_cast<std::uint32_t>(done_)};
    const Event event = checkPlace(blocks, to, fetched->size());
    if (event != Event::None) return fail(event);
    blocks.write(to, *fetched);
    done_ += fetched->size();
  }
}

// NDR and errors in the order in which they happened; one in a call.
void ServeBlock::report(unsigned calls) {
  const auto outcome = interface_.link()->takeOutcome();
  if (!outcome) return;
  if (outcome->event == Event::None) job_ = outcome->job;
  state_.report(answerOf(outcome->event), calls);
}

void ServeBlock::reset() {
  if (!interface_.link()->serving()) return state_.report(kDone, CallState::kReset);
  interface_.link()->disable(Event::Reset);
  report(CallState::kReset);
}

void ServeBlock::work(const Control& control, LinkMemory& memory, Instant now) {
  if (state_.takeReset()) reset();
  if (!control.request || control.reset)
    interface_.link()->disable(Event::Reset);
  else
    interface_.link()->serve(memory, now);
  if (!state_.reporting()) report(0);
}

ServeBlock::Served ServeBlock::call(const Control& control, LinkMemory& memory, Instant now) {
  state_.call(control.instance, false, control.reset);
  if (!state_.starting() && control.permitted)
    work(control, memory, now);
  else if (!state_.starting() && control.request && !state_.reporting())
    state_.report(answerOf(Event::NotPermitted));
  Served served{state_.take().value_or(Answer{}), std::nullopt};
  if (served.answer.done) std::swap(served.job, job_);
  return served;
}

}  // namespace merker::serial
