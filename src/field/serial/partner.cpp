#include "serial/partner.h"

#include <algorithm>
#include <utility>

namespace merker::serial {
namespace {

constexpr std::size_t kRecent = 2'048;  // characters that a rule can look back

}  // namespace

Driver* Partner::protocol() const {
  if (procedure_) return procedure_.get();
  return link_.get();
}

void Partner::speak(Speaks what, const ProcedureParameters& parameters, Instant now) {
  speaks_ = what;
  procedure_.reset();
  link_.reset();
  characters_.clear();
  telegrams_.clear();
  delayed_.clear();
  recent_.clear();
  waiting_ = 0;
  ended_.reset();
  forget();
  Inbox& inbox = *this;
  if (what == Speaks::Procedure) procedure_ = std::make_unique<Procedure>(parameters, inbox);
  if (what == Speaks::ComputerLink)
    link_ = std::make_unique<Rk512>(LinkParameters{.procedure = parameters});
  if (Driver* driver = protocol()) driver->start(now);
  pump(now);
}

bool Partner::send(const Bytes& data, Instant now) {
  if (data.size() > room()) return false;
  waiting_ += data.size();
  if (protocol() == nullptr)
    characters_.insert(characters_.end(), data.begin(), data.end());
  else
    telegrams_.push_back(data);
  pump(now);
  return true;
}

bool Partner::begin(const LinkJob& job, Bytes data, Instant now) {
  if (!link_ || !link_->outbox().free()) return false;
  jobData_ = std::move(data);
  ended_.reset();
  link_->begin(job, now);
  pump(now);
  return true;
}

bool Partner::answer(const Rule& rule) {
  if (rules_.size() >= kMostRules || rule.wanted.empty()) return false;
  rules_.push_back(rule);
  return true;
}

// The oldest goes where nobody takes anything: a hostile sender fills no memory.
void Partner::keep(Bytes bytes, Instant at, std::uint8_t faults) {
  constexpr std::size_t kOverhead = 8;
  kept_ += bytes.size() + kOverhead;
  received_.push_back({std::move(bytes), at, faults});
  for (; kept_ > kMost * (kOverhead + 1); received_.pop_front())
    kept_ -= received_.front().bytes.size() + kOverhead;
}

bool Partner::take(const Bytes& wanted) {
  if (wanted.empty()) return received_.empty();
  if (speaks_ != Speaks::Characters) {
    if (received_.empty() || received_.front().bytes != wanted) return false;
    received_.pop_front();
    return true;
  }
  if (received_.size() < wanted.size()) return false;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (received_[i].bytes[0] != wanted[i] || received_[i].faults != 0) return false;
  received_.erase(received_.begin(),
                  received_.begin() + static_cast<std::ptrdiff_t>(wanted.size()));
  return true;
}

Bytes Partner::takeAll() {
  Bytes all;
  for (const Received& one : received_) all.insert(all.end(), one.bytes.begin(), one.bytes.end());
  forget();
  return all;
}

bool Partner::fits(const Rule& rule) const {
  if (arrived_)
    return arrived_->size() >= rule.wanted.size() &&
           std::equal(rule.wanted.begin(), rule.wanted.end(), arrived_->begin());
  return recent_.size() >= rule.wanted.size() &&
         std::equal(rule.wanted.rbegin(), rule.wanted.rend(), recent_.rbegin());
}

// The first rule that fits; characters that were answered are no part of a further one.
void Partner::react(Instant at) {
  const auto rule = std::ranges::find_if(rules_, [this](const Rule& r) { return fits(r); });
  arrived_.reset();
  if (rule == rules_.end()) return;
  recent_.clear();
  if (delayed_.size() < kMostDelayed) delayed_.emplace(at + rule->after, rule->answer);
}

void Partner::received(const Character& character) {
  now_ = character.at;
  if (Driver* driver = protocol()) {
    driver->received(character);
    return pump(character.at);
  }
  keep({character.value}, character.at, character.faults);
  if (!character.good()) return;
  recent_.push_back(character.value);
  if (recent_.size() > kRecent) recent_.pop_front();
  react(character.at);
}

Event Partner::put(Bytes telegram) {
  keep(telegram, now_, 0);
  arrived_ = std::move(telegram);
  react(now_);
  return Event::None;
}

// The next telegram, and what a computer link needs: data, service.
void Partner::pump(Instant now) {
  if (procedure_) {
    if (const auto end = procedure_->outbox().takeEnd()) ended_ = end;
    if (procedure_->outbox().free() && !telegrams_.empty()) {
      procedure_->send(telegrams_.front(), now);
      waiting_ -= telegrams_.front().size();
      telegrams_.pop_front();
    }
  }
  if (link_) pumpLink(now);
}

void Partner::pumpLink(Instant now) {
  link_->serve(memory_, now);
  while (link_->takeOutcome()) {
  }
  if (const auto part = link_->wanted()) {
    const auto from =
        jobData_.begin() + static_cast<std::ptrdiff_t>(std::min(part->offset, jobData_.size()));
    const auto left = static_cast<std::size_t>(jobData_.end() - from);
    link_->supply(Bytes(from, from + static_cast<std::ptrdiff_t>(std::min(part->count, left))),
                  now);
  }
  if (auto fetched = link_->takeFetched(now)) keep(std::move(*fetched), now, 0);
  if (const auto end = link_->outbox().takeEnd()) ended_ = end;
}

void Partner::start(Instant now) {
  if (Driver* driver = protocol()) driver->start(now);
}

void Partner::interrupted(Instant at) {
  if (Driver* driver = protocol()) driver->interrupted(at);
  pump(at);
}

void Partner::restored(Instant at) {
  if (Driver* driver = protocol()) driver->restored(at);
  pump(at);
}

std::optional<std::uint8_t> Partner::next(Instant now) {
  if (Driver* driver = protocol()) return driver->next(now);
  if (characters_.empty()) return std::nullopt;
  const std::uint8_t first = characters_.front();
  characters_.pop_front();
  --waiting_;
  return first;
}

void Partner::sent(Instant at) {
  now_ = at;
  if (Driver* driver = protocol()) driver->sent(at);
  pump(at);
}

Instant Partner::due() const {
  const Instant answer = delayed_.empty() ? Instant::never() : delayed_.begin()->first;
  const Driver* driver = protocol();
  return driver == nullptr ? answer : std::min(answer, driver->due());
}

void Partner::expire(Instant now) {
  now_ = now;
  while (!delayed_.empty() && delayed_.begin()->first <= now) {
    const Bytes answer = std::move(delayed_.begin()->second);
    delayed_.erase(delayed_.begin());
    send(answer, now);
  }
  if (Driver* driver = protocol(); driver != nullptr && driver->due() <= now) driver->expire(now);
  pump(now);
}

}  // namespace merker::serial
