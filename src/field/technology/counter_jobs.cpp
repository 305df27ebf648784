// The jobs of SFB 47 (technology manual 5.5.6, 5.10.3; CNT-JOB-05 to -10, CNT-ERR-02).
#include <limits>

#include "technology/counter.h"

namespace merker::technology {
namespace {

using io::CountDirection;

constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::uint16_t kInvalidJob = 0x01FF;

// Of count and load value.
JobRange countRange(const io::CountChannel& p, std::uint16_t tooSmall) {
  switch (p.direction) {
    case CountDirection::Forward:
      return {kLowest, std::int64_t{p.endValue} - 2, tooSmall};
    case CountDirection::Backward:
      return {2, kHighest, tooSmall};
    default:
      return {kLowest + 1, kHighest - 1, tooSmall};
  }
}

JobRange comparisonRange(const io::CountChannel& p) {
  switch (p.direction) {
    case CountDirection::Forward:
      return {kLowest, std::int64_t{p.endValue} - 1, 0x0121};
    case CountDirection::Backward:
      return {1, kHighest, 0x0121};
    default:
      return {kLowest, kHighest, 0x0121};
  }
}

}  // namespace

JobResult Counter::job(std::uint32_t id, std::int32_t value) {
  JobResult result;
  const auto accepted = [&](const JobRange& range) {
    result.error = range.check(value);
    return result.error == 0;
  };
  const auto shows = [](std::int32_t read) { return JobResult{0, true, read}; };
  switch (id) {
    case 0x00:
      break;
    case 0x01:
      if (!accepted(countRange(p_, 0x0161))) break;
      count_ = value;
      for (Place* place : {&zero_, &overflow_, &underflow_}) place->moved(count_);
      zeroReached();
      raise(comparator_.look(count_) && p_.onComparator, io::kComparator);
      break;
    case 0x02:
      if (accepted(countRange(p_, 0x0151))) loadValue_ = value;
      break;
    case 0x04:
      if (!accepted(comparisonRange(p_))) break;
      comparator_.write(value, count_);
      raise(comparator_.look(count_) && p_.onComparator, io::kComparator);
      break;
    case 0x08:
      if (accepted({0, 255, 0x0131})) comparator_.hysteresis = value;
      break;
    case 0x10:  // odd ones are rounded down (CNT-JOB-10)
      if (accepted({0, 510, 0x0141})) comparator_.duration = value / 2 * 2;
      break;
    case 0x82:
      return shows(loadValue_);
    case 0x84:
      return shows(comparator_.value);
    case 0x88:
      return shows(comparator_.hysteresis);
    case 0x90:
      return shows(comparator_.duration);
    default:
      result.error = kInvalidJob;
  }
  return result;
}

}  // namespace merker::technology
