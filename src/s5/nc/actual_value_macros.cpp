#include "nc/actual_value_macros.h"

#include <algorithm>

#include "nc/bcd_value.h"
#include "nc/plc_memory.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;

constexpr unsigned kOrder = 224, kLow = 225, kHigh = 227;
constexpr std::int32_t kMostFeedDigits = 9'999'999;  // seven and the point
constexpr std::uint16_t kTypeOrChannel = 1, kPathOrAxis = 2, kNumber = 1;

void give(Machine& m, std::uint32_t value) {
  setFlagWord(m, kLow, value & 0xFFFF);
  setFlagWord(m, kHigh, value >> 16);
}

// Eight nibbles, E is the point, the lowest byte first (S5-FM-16). Decimals that find no room are
// cut.
void giveFeed(Machine& m, Number feed) {
  unsigned places = feed.places;
  const std::int64_t digits = std::max(feed.digits, 0);
  while (places > 0 && scaled(digits, feed.places, places) > kMostFeedDigits) --places;
  const auto shown = std::min<std::int64_t>(scaled(digits, feed.places, places), kMostFeedDigits);
  const auto nibbles =
      static_cast<std::uint32_t>(bcdNibbles(static_cast<std::uint64_t>(shown), places, true));
  setFlagWord(m, kLow, (nibbles & 0xFF) << 8 | (nibbles >> 8 & 0xFF));
  setFlagWord(m, kHigh, (nibbles >> 16 & 0xFF) << 8 | nibbles >> 24);
}

// Channel 0: the one in which the axis is programmed. An axis has no feed in another channel.
Number axialFeed(const Axis& axis, unsigned channel, unsigned type) {
  return channel == 0 || channel == axis.channel ? axis.feed.at(type) : Number{};
}

}  // namespace

Error readFeed(Machine& m, const Control& control) {
  const unsigned order = m.flags[kOrder];
  const unsigned axis = order >> 4, type = order >> 2 & 3, channel = order & 3;
  if (axis > kAxes) return kPathOrAxis;
  if (type >= kFeedTypes || channel > kChannels) return kTypeOrChannel;
  if (axis == 0 && channel == 0) return kTypeOrChannel;
  giveFeed(m, axis == 0 ? control.channels.at(channel - 1).pathFeed.at(type)
                        : axialFeed(control.axes.at(axis - 1), channel, type));
  return std::nullopt;
}

Error readFollowingError(Machine& m, const Control& control) {
  const unsigned axis = m.flags[kOrder];
  if (axis < 1 || axis > kAxes) return kNumber;
  give(m, static_cast<std::uint32_t>(control.axes.at(axis - 1).followingError));
  return std::nullopt;
}

Error readSpindleSpeed(Machine& m, const Control& control) {
  const unsigned spindle = m.flags[kOrder];
  if (spindle < 1 || spindle > kSpindles) return kNumber;
  give(m, static_cast<std::uint32_t>(control.spindleSpeed.at(spindle - 1)));
  return std::nullopt;
}

}  // namespace merker::nc
