#include "system/alarms.h"

#include <algorithm>

namespace merker::system {

const Alarm* Alarms::find(std::uint32_t number) const {
  const auto at = list_.find(number);
  return at == list_.end() ? nullptr : &at->second;
}

// Each call must invert the signal; the first one must have 1.
Alarms::Result Alarms::report(const Report& report) {
  if (report.number == 0) return Result::BadNumber;
  const Alarm* known = find(report.number);
  if (known == nullptr && !report.signal.state) return Result::FirstIsZero;
  if (known == nullptr && list_.size() >= kMost) return Result::NoMemory;
  if (known != nullptr && known->function != report.function) return Result::OtherFunction;
  if (known != nullptr && known->last.state == report.signal.state) return Result::SameSignal;
  Alarm& alarm = list_[report.number];
  if (unsent(report.number) >= kUnsent) {  // this transition and the one before it are lost
    alarm.overflow = true;
    return Result::Overflow;
  }
  alarm.number = report.number;
  alarm.function = report.function;
  alarm.component = report.component;
  alarm.last = report.signal;
  if (report.signal.state) alarm.coming = report.signal;
  if (report.signal.state) alarm.acknowledged = !alarm.waitsForAcknowledgement();
  const bool heard = listeners_ > 0;
  if (heard && !locked_.contains(report.number)) queue_.push_back({alarm, report.signal, false});
  forget(report.number);
  return heard ? Result::Good : Result::NobodyListens;
}

// The memory of a message is free when its signal has gone and nobody has to acknowledge it.
void Alarms::forget(std::uint32_t number) {
  const Alarm& alarm = list_.at(number);
  if (!alarm.last.state && alarm.acknowledged) list_.erase(number);
}

std::size_t Alarms::unsent(std::uint32_t number) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(queue_, [number](const AlarmMessage& message) {
        return !message.isAcknowledgement && message.alarm.number == number;
      }));
}

void Alarms::logOff() {
  if (listeners_ > 0 && --listeners_ == 0) queue_.clear();
}

bool Alarms::acknowledge(std::uint32_t number) {
  const auto at = list_.find(number);
  if (at == list_.end() || at->second.acknowledged) return false;
  at->second.acknowledged = true;
  if (listeners_ > 0) queue_.push_back({at->second, at->second.last, true});
  forget(number);
  return true;
}

bool Alarms::lock(std::uint32_t number, bool locked) {
  if (!locked) locked_.erase(number);
  if (locked && locked_.size() >= kMost && !locked_.contains(number)) return false;
  if (locked) locked_.insert(number);
  return true;
}

std::vector<AlarmMessage> Alarms::take() {
  std::vector<AlarmMessage> result(queue_.begin(), queue_.end());
  for (AlarmMessage& message : result)
    if (const auto at = list_.find(message.alarm.number);
        at != list_.end() && at->second.overflow) {
      message.alarm.overflow = true;
      at->second.overflow = false;
    }
  queue_.clear();
  return result;
}

void Alarms::clear() {
  list_.clear();
  locked_.clear();
  queue_.clear();
}

}  // namespace merker::system
