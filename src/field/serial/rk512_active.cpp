// The active half of RK 512: SEND and FETCH of the CPU (PTP-RK512-32 to -39).
#include <algorithm>
#include <utility>

#include "serial/rk512.h"

namespace merker::serial {
namespace {

constexpr std::size_t kOwed = 8;  // a program that aborts all the time fills no memory

}  // namespace

void Rk512::begin(const LinkJob& job, Instant now) {
  outbox_.begin();
  job_ = job;
  done_ = 0;
  fetched_.clear();
  doubtful_.reset();
  if (!job.fetch) {
    active_ = Active::NeedsData;
    return;
  }
  command_ = firstCommand(job_);
  prepare(now, part());
}

// Bytes on the line for the next telegram of the job.
std::size_t Rk512::part() const { return std::min(kPart, job_.transferred() - done_); }

std::optional<Rk512::Part> Rk512::wanted() const {
  if (active_ != Active::NeedsData) return std::nullopt;
  return Part{done_, std::min(kPart, job_.length - done_)};
}

// An odd number of bytes gets a filler (PTP-RK512-17).
void Rk512::supply(Bytes data, Instant now) {
  if (active_ != Active::NeedsData) return;
  data.resize(part());
  command_ = done_ == 0 ? firstCommand(job_) : followOnCommand(job_);
  command_.insert(command_.end(), data.begin(), data.end());
  prepare(now, data.size());
}

void Rk512::prepare(Instant now, std::size_t bytes) {
  Preparation preparation = parameters_.preparation;
  if (done_ > 0) preparation.fixed = {};
  active_ = Active::Prepares;
  activeTimer_ = now + preparation.of(bytes);
}

void Rk512::endJob(Event event) {
  active_ = Active::Idle;
  activeTimer_ = Instant::never();
  commandReady_ = false;
  outbox_.end(event);
}

// The partner reacts to a command that it has acknowledged, even if nobody waits any more.
void Rk512::abort(Event why) {
  if (!outbox_.busy()) return;
  if (active_ == Active::Waits && owed_.size() < kOwed)
    owed_.push_back({activeTimer_, done_ > 0, job_.fetch ? part() : 0});
  if (output_ == Output::CommandTelegram) procedure_.abort(why);
  endJob(why);
}

// The monitoring time begins with the partner's DLE (PTP-RK512-26).
void Rk512::commandSent(Event event, Instant now) {
  if (active_ != Active::Sends) return;  // aborted
  if (event != Event::None) return endJob(event);
  active_ = Active::Waits;
  activeTimer_ = now + parameters_.reactionTime;
}

// It comes within its monitoring time, with the data of the aborted job or an error.
bool Rk512::ofAbortedJob(const Bytes& telegram) {
  while (!owed_.empty() && owed_.front().until < now_) owed_.pop_front();
  if (owed_.empty() || telegram.size() < 4) return false;
  const bool followOn = telegram[0] == 0xFF;
  const std::size_t data = telegram[3] == 0 ? owed_.front().data : 0;
  if (followOn != owed_.front().followOn || telegram.size() != 4 + data) return false;
  owed_.pop_front();
  return true;
}

// Without a job that waits for it a reaction is discarded (PTP-RK512-29, -39). Each command is
// answered once, in turn: if one more reaction comes, that is the one of this job.
void Rk512::takeReaction(const Bytes& telegram) {
  const bool doubtful = ofAbortedJob(telegram);
  if (active_ != Active::Waits) return;
  if (doubtful)
    doubtful_ = telegram;
  else
    useReaction(telegram);
}

// The partner has answered only once: it did not know of the aborted job any more.
void Rk512::reactionOverdue() {
  if (const auto telegram = std::exchange(doubtful_, std::nullopt)) return useReaction(*telegram);
  endJob(Event::NoReaction);
}

void Rk512::useReaction(const Bytes& telegram) {
  doubtful_.reset();
  const bool followOn = telegram[0] == 0xFF;
  if (telegram[0] != 0x00 && !followOn) return endJob(Event::ReactionByte1);
  if (followOn != (done_ > 0)) return endJob(Event::ReactionSequence);
  if (telegram.size() < 4) return endJob(Event::ReactionLength);
  if (telegram[3] != 0) return endJob(eventOfReaction(telegram[3]));
  if (telegram.size() - 4 != (job_.fetch ? part() : 0)) return endJob(Event::ReactionLength);
  activeTimer_ = Instant::never();
  if (job_.fetch) {
    fetched_.assign(telegram.begin() + 4, telegram.end());
    active_ = Active::HasData;
    return;
  }
  done_ += part();
  if (done_ >= job_.transferred()) return endJob(Event::None);
  active_ = Active::NeedsData;
}

// Exactly as many bytes as the job asked for (PTP-RK512-18).
std::optional<Bytes> Rk512::takeFetched(Instant now) {
  if (active_ != Active::HasData) return std::nullopt;
  Bytes data = std::exchange(fetched_, {});
  const std::size_t rest = job_.length - done_;
  done_ += data.size();
  data.resize(std::min(data.size(), rest));
  if (done_ >= job_.transferred()) {
    endJob(Event::None);
  } else {
    command_ = followOnCommand(job_);
    prepare(now, part());
  }
  return data;
}

}  // namespace merker::serial
