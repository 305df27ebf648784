// The passive half of RK 512: commands of the partner, executed when SERVE_RK is called
// (PTP-RK512-40 to -46).
#include <algorithm>
#include <utility>

#include "serial/rk512.h"

namespace merker::serial {
namespace {

constexpr std::size_t kOutcomes = 16, kReplies = 8;  // a hostile partner fills no memory

std::uint8_t errorOf(const LinkJob& job) { return job.type == 'D' ? 0x14 : 0x0C; }

// Bytes 5 and 6. Numbers: PTP-OPEN-14.
Denial checkAddress(const LinkMemory& memory, const LinkJob& job) {
  const auto size = memory.size(job.type, job.block);
  if (size && job.offset < *size) return {};
  return {job.type == 'D' ? Event::AreaNotPermitted : Event::HeaderAddress, errorOf(job)};
}

// Up to its end, and that a SEND can be stored.
Denial checkArea(const LinkMemory& memory, const LinkJob& job) {
  const Denial address = checkAddress(memory, job);
  if (address.event != Event::None) return address;
  const bool words = job.type == 'T' || job.type == 'Z';
  const std::size_t count = words ? job.length / 2U : job.length;
  if (job.offset + count > memory.size(job.type, job.block))
    return {Event::AreaNotPermitted, errorOf(job)};
  if (!job.fetch && !memory.writable(job.block)) return {Event::NoAccess, errorOf(job)};
  return {};
}

Denial checkFlag(const LinkMemory& memory, const Flag& flag) {
  if (!flag.used()) return {};
  if (flag.byte >= memory.size('M', 0).value_or(0)) return {Event::AreaNotPermitted, 0x0C};
  if (memory.flag(flag)) return {Event::Locked, 0x32};
  return {};
}

}  // namespace

void Rk512::outcome(Event event) {
  if (outcomes_.size() < kOutcomes) outcomes_.push_back({event, {}});
}

void Rk512::report(Event event) { outcome(event); }

void Rk512::react(Bytes telegram, bool ofJob) {
  if (replies_.size() < kReplies)
    replies_.push_back({std::move(telegram), ofJob});
  else if (ofJob)
    passive_ = Passive::Idle;
}

// The job ends; `event` None: nothing is wrong with the telegram, the CPU is not ready.
void Rk512::refuse(bool followOn, Event event, std::uint8_t error) {
  if (event != Event::None) outcome(event);
  react(reaction(followOn, error), false);
  passive_ = Passive::Idle;
  passiveTimer_ = Instant::never();
}

void Rk512::takeCommand(const Bytes& telegram) {
  constexpr std::uint8_t kNotStarted = 0x2A, kNotReady = 0x0A, kSequence = 0x36;
  const Command command = read(telegram);
  const bool served = !stopped_ && service_ == Service::Enabled && passive_ == Passive::Idle;
  if (command.event != Event::None && !(command.addressed && served))
    return refuse(command.followOn, command.event, command.error);
  if (stopped_ || service_ == Service::Disabled)
    return refuse(command.followOn, Event::None, kNotReady);
  if (service_ == Service::Never) return refuse(command.followOn, Event::None, kNotStarted);
  const Passive expected = command.followOn ? Passive::Follows : Passive::Idle;
  if (passive_ != expected) return refuse(command.followOn, Event::Sequence, kSequence);
  if (command.followOn) {
    if (!continues(telegram)) return;
  } else {
    partnerJob_ = command.job;
    header_ = {command.event, command.error};
    served_ = 0;
  }
  followOn_ = command.followOn;
  data_.assign(telegram.begin() + static_cast<std::ptrdiff_t>(command.header), telegram.end());
  passive_ = Passive::Pending;
  passiveTimer_ = now_ + parameters_.reactionTime;
}

std::size_t Rk512::partnerPart() const { return std::min(kPart, partnerJob_.length - served_); }

// A follow-on telegram has the letters of the first one, and the data that are missing.
bool Rk512::continues(const Bytes& telegram) {
  const Bytes header = followOnCommand(partnerJob_);
  const std::size_t data = partnerJob_.fetch ? 0 : partnerPart();
  if (telegram[2] != header[2])
    refuse(true, Event::FollowByte3, 0x16);
  else if (telegram[3] != header[3])
    refuse(true, Event::HeaderByte4, 0x10);
  else if (telegram.size() != header.size() + data)
    refuse(true, Event::HeaderLength, 0x34);
  else
    return true;
  return false;
}

// What the partner's job did is reported in a call behind the one that did it, and the coordination
// flag set before (PTP-RK512-43).
void Rk512::serve(LinkMemory& memory, Instant now) {
  now_ = now;
  service_ = Service::Enabled;
  if (completed_) {
    if (completed_->flag.used()) memory.setFlag(completed_->flag);
    outcomes_.push_back({Event::None, *completed_});
    completed_.reset();
  }
  if (passive_ == Passive::Pending) execute(memory);
  pump(now);
}

// In the order of the bytes (PTP-RK512-40). The area may have changed since the last telegram.
Denial Rk512::check(const LinkMemory& memory) const {
  const Denial address = checkAddress(memory, partnerJob_);
  if (address.event != Event::None) return address;
  if (header_.event != Event::None) return header_;
  const Denial area = checkArea(memory, partnerJob_);
  if (area.event != Event::None || served_ > 0) return area;
  return checkFlag(memory, partnerJob_.flag);
}

void Rk512::execute(LinkMemory& memory) {
  const Denial denial = check(memory);
  if (denial.event != Event::None) return refuse(followOn_, denial.event, denial.error);
  const bool words = partnerJob_.type == 'T' || partnerJob_.type == 'Z';
  const std::size_t at = partnerJob_.offset + (words ? served_ / 2 : served_);
  const std::size_t count = partnerPart();
  Bytes telegram = reaction(followOn_, 0);
  if (partnerJob_.fetch) {
    const Bytes data = memory.read(partnerJob_.type, partnerJob_.block, at, count);
    telegram.insert(telegram.end(), data.begin(), data.end());
  } else {
    memory.write(partnerJob_.block, at, data_);
  }
  served_ += count;
  passive_ = Passive::Reacts;
  passiveTimer_ = Instant::never();
  react(std::move(telegram), true);
}

void Rk512::reactionSent(Event event, Instant now) {
  if (!std::exchange(replyOfJob_, false) || passive_ != Passive::Reacts) return;
  passive_ = Passive::Idle;
  if (event != Event::None) return outcome(event);
  if (served_ >= partnerJob_.length) {
    completed_ = partnerJob_;
    return;
  }
  passive_ = Passive::Follows;
  passiveTimer_ = now + parameters_.reactionTime;
}

// No SERVE_RK: the partner has given up as well. No follow-on telegram: an error (PTP-RK512-45).
void Rk512::passiveExpired() {
  if (passive_ == Passive::Follows) outcome(Event::Sequence);
  passive_ = Passive::Idle;
  passiveTimer_ = Instant::never();
}

// EN_R is FALSE, or the CPU stops: what has begun ends with an error (PTP-RK512-46).
void Rk512::disable(Event why) {
  service_ = Service::Disabled;
  if (passive_ == Passive::Pending)
    refuse(followOn_, why, 0x0A);
  else if (passive_ == Passive::Follows)
    outcome(why);
  if (passive_ != Passive::Reacts) passive_ = Passive::Idle;
  passiveTimer_ = Instant::never();
}

std::optional<Rk512::Outcome> Rk512::takeOutcome() {
  if (outcomes_.empty()) return std::nullopt;
  const Outcome first = outcomes_.front();
  outcomes_.pop_front();
  return first;
}

void Rk512::cpuStopped() {
  stopped_ = true;
  abort(Event::Restarted);
  disable(Event::Restarted);
}

void Rk512::cpuStarted() {
  stopped_ = false;
  service_ = Service::Never;
}

}  // namespace merker::serial
