#include "plant/belt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "plant/repeated_sum.h"

namespace merker::plant {
namespace {

constexpr double kHit = 0.03;     // m that a box may stand beside the middle of the slider
constexpr double kPlate = 0.04;   // half the width of a slider
constexpr double kHalfOut = 0.5;  // of the stroke: the slider is at the box

double middle(const Box& box) { return box.front - Belt::kLength / 2; }

double strokeAfter(double stroke, double way, bool out) {
  return std::clamp(stroke + (out ? way : -way), 0.0, 1.0);
}

double pushedAfter(double pushed, double way) { return std::max(pushed, kHalfOut) + way; }

bool onBelt(const Box& box) { return box.size != BoxSize::None && box.slider < 0; }

}  // namespace

bool Belt::put(BoxSize size) {
  Box* free = nullptr;
  for (Box& box : boxes_) {
    if (onBelt(box) && box.front < kStart + kLength) return false;
    if (box.size == BoxSize::None) free = &box;
  }
  if (free != nullptr) *free = {size, kStart};
  return free != nullptr;
}

void Belt::move(double seconds, double metresPerSecond, const std::array<bool, kSliders>& out) {
  for (std::size_t i = 0; i < kSliders; ++i)
    if (moveSlider(i, out[i], seconds)) push(i);
  std::array<Box*, kBoxes> order{};
  auto end = order.begin();
  for (Box& box : boxes_)
    if (box.size != BoxSize::None) *end++ = &box;
  std::sort(order.begin(), end, [](Box* a, Box* b) { return a->front > b->front; });
  for (Box* box : std::span(order.begin(), end)) {
    if (box->slider >= 0) slide(*box, seconds);
    if (onBelt(*box)) carry(*box, seconds * metresPerSecond);
    if (onBelt(*box) && box->front > kEnd) lose(*box);
  }
}

void Belt::move(double seconds, double metresPerSecond, const std::array<bool, kSliders>& out,
                std::int64_t count) {
  constexpr std::int64_t kOneByOne = 16;  // before it is worth looking again
  const double way = seconds * metresPerSecond;
  while (count > 0) {
    std::int64_t steps = std::min(count, freeSteps(seconds / kStrokeTime, out));
    if (steps > 0 && way >= 0 && freeFor(way * static_cast<double>(steps))) {
      carryFreely(way, steps);
      moveSliders(seconds / kStrokeTime, out, steps);
    } else {
      steps = std::min(count, kOneByOne);
      for (std::int64_t i = 0; i < steps; ++i) move(seconds, metresPerSecond, out);
    }
    count -= steps;
  }
}

// So many steps for which surely no slider comes to the boxes, and none has pushed one into a bin.
// `stroke`: of a slider in a step.
std::int64_t Belt::freeSteps(double stroke, const std::array<bool, kSliders>& out) const {
  double steps = 1e9;
  const auto upTo = [&](double way) { steps = std::min(steps, way / stroke - 1); };
  for (std::size_t i = 0; i < kSliders; ++i)
    if (out[i] && strokes_[i] < kHalfOut) upTo(kHalfOut - strokes_[i]);
  for (const Box& box : boxes_)
    if (box.slider >= 0) upTo(1 - std::max(box.pushed, kHalfOut));
  return static_cast<std::int64_t>(std::max(steps, 0.0));
}

void Belt::carryFreely(double way, std::int64_t count) {
  for (Box& box : boxes_)
    if (onBelt(box)) box.front = addRepeatedly(box.front, way, count);
}

void Belt::moveSliders(double stroke, const std::array<bool, kSliders>& out, std::int64_t count) {
  for (std::size_t i = 0; i < kSliders; ++i)
    for (std::int64_t step = 0; step < count && strokes_[i] != (out[i] ? 1 : 0); ++step)
      strokes_[i] = strokeAfter(strokes_[i], stroke, out[i]);
  for (Box& box : boxes_)
    for (std::int64_t step = 0; step < count && box.slider >= 0; ++step)
      box.pushed = pushedAfter(box.pushed, stroke);
}

// No box comes to a slider, to the end or near another one within this way of the belt.
bool Belt::freeFor(double way) const {
  constexpr double kNear = 1e-6;  // m
  return std::ranges::all_of(boxes_, [&](const Box& box) {
    if (!onBelt(box)) return true;
    for (const Box& other : boxes_)
      if (onBelt(other) && &other != &box && std::abs(other.front - box.front) < kLength + kNear)
        return false;
    const double reached = box.front + way + kNear;
    for (std::size_t i = 0; i < kSliders; ++i)
      if (strokes_[i] >= kHalfOut && box.front <= kPlaces[i] - kPlate &&
          reached >= kPlaces[i] - kPlate)
        return false;
    return reached < kEnd;
  });
}

// Whether it has just come to the boxes.
bool Belt::moveSlider(std::size_t slider, bool out, double seconds) {
  const double before = strokes_[slider];
  strokes_[slider] = strokeAfter(before, seconds / kStrokeTime, out);
  return before < kHalfOut && strokes_[slider] >= kHalfOut;
}

// A box right in front of the slider goes into the bin, one at its edge falls off the belt.
void Belt::push(std::size_t slider) {
  for (Box& box : boxes_) {
    if (!onBelt(box)) continue;
    const double beside = std::abs(middle(box) - kPlaces[slider]);
    if (beside <= kHit)
      box.slider = static_cast<int>(slider);
    else if (beside < kPlate + kLength / 2)
      lose(box);
  }
}

void Belt::slide(Box& box, double seconds) {
  box.pushed = pushedAfter(box.pushed, seconds / kStrokeTime);
  if (box.pushed >= 1) deliver(box);
}

void Belt::carry(Box& box, double way) const {
  box.front = std::max(box.front, std::min(box.front + way, obstacle(box)));
}

// Where the next box or the next slider that is out begins.
double Belt::obstacle(const Box& box) const {
  double nearest = kEnd + kLength;
  for (const Box& other : boxes_)
    if (onBelt(other) && other.front > box.front)
      nearest = std::min(nearest, other.front - kLength);
  for (std::size_t i = 0; i < kSliders; ++i)
    if (strokes_[i] >= kHalfOut && box.front <= kPlaces[i] - kPlate)
      nearest = std::min(nearest, kPlaces[i] - kPlate);
  return nearest;
}

// A box that stands in the way of another only makes it later; sliders take boxes far behind the
// barriers.
double Belt::silence(double metresPerSecond) const {
  static_assert(kPlaces[0] - kPlate > kLength);
  double seconds = std::numeric_limits<double>::infinity();
  const auto within = [&](double way) {
    if (way >= 0 && metresPerSecond > 0) seconds = std::min(seconds, way / metresPerSecond);
  };
  for (const Box& box : boxes_) {
    if (!onBelt(box)) continue;
    within(-box.front);
    within(kLength - box.front);
  }
  return metresPerSecond < 0 ? 0 : seconds;
}

double Belt::timeToBarriers(double metresPerSecond) {
  return metresPerSecond > 0 ? -kStart / metresPerSecond : std::numeric_limits<double>::infinity();
}

bool Belt::interrupted(BoxSize from) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [from](const Box& box) {
    return onBelt(box) && box.size >= from && box.front > 0 && box.front < kLength;
  });
}

void Belt::deliver(Box& box) {
  ++counts_.bins[static_cast<std::size_t>(box.slider)];
  ++(static_cast<int>(box.size) == box.slider + 1 ? counts_.good : counts_.wrong);
  box = {};
}

void Belt::lose(Box& box) {
  ++counts_.wrong;
  box = {};
}

}  // namespace merker::plant
