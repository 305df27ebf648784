#include "softplc/alarm_list.h"

#include <algorithm>

namespace merker::sinumerik {
namespace {

constexpr std::size_t kHistory = 200;

}  // namespace

bool AlarmList::pending(unsigned number) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [number](const PendingAlarm& a) { return a.number == number; });
}

bool AlarmList::add(unsigned number, std::string text, Instant now, bool stops) {
  if (pending(number)) return false;
  pending_.push_back({number, now, std::move(text), stops});
  return true;
}

bool AlarmList::announce(unsigned number, std::string text, Instant now, bool stops) {
  if (!add(number, text, now, stops)) return false;
  note(number, std::move(text), now);
  return true;
}

void AlarmList::withdraw(unsigned number) {
  std::erase_if(pending_, [number](const PendingAlarm& a) { return a.number == number; });
}

bool AlarmList::acknowledge(unsigned number) {
  return std::erase_if(pending_, [number](const PendingAlarm& a) {
           return a.number == number && !a.stops;
         }) > 0;
}

std::vector<PendingAlarm> AlarmList::shown() const {
  std::vector<PendingAlarm> list = pending_;
  std::stable_partition(list.begin(), list.end(),
                        [](const PendingAlarm& a) { return a.number == kPlcStop; });
  return list;
}

void AlarmList::note(unsigned number, std::string text, Instant now) {
  if (history_.size() == kHistory) history_.erase(history_.begin());
  history_.push_back({number, now, std::move(text)});
}

}  // namespace merker::sinumerik
