// The sorting plant of the course: boxes of three sizes, three light barriers, three sliders
// (S7-VIS-07 to S7-VIS-16). Boxes are put on the belt by hand (NEW_...) or by themselves (AUTO):
// each three of them have one of each size, in an order that follows from the seed.
#include <algorithm>
#include <limits>
#include <random>

#include "plant/belt.h"
#include "plant/delay.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/repeated_sum.h"
#include "plant/silence.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr Parameter kParameters[] = {
    {"speed", Parameter::Form::Number, 0.1, 0.001, 1},  // m/s at 100 %
    {"interval", Parameter::Form::Time, 10, 1, 3600},   // between two boxes of AUTO
    {"automatic", Parameter::Form::Number, 0, 0, 1},    // AUTO at the start
    {"seed", Parameter::Form::Number, 1, 0, 4294967295},
};
constexpr Signal kSignals[] = {
    {"SLIDER_SMALL", Side::Input, true},
    {"SLIDER_MIDDLE", Side::Input, true},
    {"SLIDER_LARGE", Side::Input, true},
    {"BELT", Side::Input, true, 1},
    {"SPEED", Side::Input, false, 100, 0, 200, "%"},
    {"AUTO", Side::Input, true},
    {"NEW_SMALL", Side::Input, true},
    {"NEW_MIDDLE", Side::Input, true},
    {"NEW_LARGE", Side::Input, true},
    {"BARRIER_SMALL", Side::Output, true},  // 0: interrupted (S7-VIS-10)
    {"BARRIER_MIDDLE", Side::Output, true},
    {"BARRIER_LARGE", Side::Output, true},
    {"GOOD", Side::Output},
    {"WRONG", Side::Output},
    {"BIN_SMALL", Side::Output},
    {"BIN_MIDDLE", Side::Output},
    {"BIN_LARGE", Side::Output},
    {"STROKE_SMALL", Side::Output, false, 0, 0, 1},  // where the sliders are: 0 in, 1 out
    {"STROKE_MIDDLE", Side::Output, false, 0, 0, 1},
    {"STROKE_LARGE", Side::Output, false, 0, 0, 1},
    // Of each box its size (0: there is none, 1 to 3), where its front is, how far it is pushed.
    {"BOX1", Side::Output, false, 0, 0, 3},
    {"FRONT1", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED1", Side::Output, false, 0, 0, 1},
    {"BOX2", Side::Output, false, 0, 0, 3},
    {"FRONT2", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED2", Side::Output, false, 0, 0, 1},
    {"BOX3", Side::Output, false, 0, 0, 3},
    {"FRONT3", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED3", Side::Output, false, 0, 0, 1},
    {"BOX4", Side::Output, false, 0, 0, 3},
    {"FRONT4", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED4", Side::Output, false, 0, 0, 1},
    {"BOX5", Side::Output, false, 0, 0, 3},
    {"FRONT5", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED5", Side::Output, false, 0, 0, 1},
    {"BOX6", Side::Output, false, 0, 0, 3},
    {"FRONT6", Side::Output, false, 0, 0, 1, "m"},
    {"PUSHED6", Side::Output, false, 0, 0, 1},
};
static_assert(areTogether(kSignals, "SLIDER_SMALL", "SLIDER_LARGE", Belt::kSliders));
static_assert(areTogether(kSignals, "NEW_SMALL", "NEW_LARGE", Belt::kSliders));
static_assert(areTogether(kSignals, "BARRIER_SMALL", "BARRIER_LARGE", Belt::kSliders));
static_assert(areTogether(kSignals, "BIN_SMALL", "BIN_LARGE", Belt::kSliders));
static_assert(areTogether(kSignals, "STROKE_SMALL", "STROKE_LARGE", Belt::kSliders));
static_assert(areTogether(kSignals, "BOX1", "PUSHED6", 3 * Belt::kBoxes));

constexpr double kFirst = 1;  // s until the first box of AUTO
constexpr std::array kSizes{BoxSize::Small, BoxSize::Middle, BoxSize::Large};

class SortingPlant : public ProcessOf<kParameters, kSignals> {
 public:
  explicit SortingPlant(Parameters parameters)
      : speed_(parameters["speed"]),
        interval_(parameters["interval"]),
        automatic_(parameters["automatic"]),
        waited_(interval_ - kFirst),
        random_(static_cast<std::uint32_t>(parameters["seed"])) {}

  void begin(Signals values) override {
    values["AUTO"] = automatic_;
    show(values);
  }

  void advance(Instant from, Instant to, Signals values) override {
    move(seconds(from, to), values);
    show(values);
  }

  // Nobody sees the outputs in between.
  void advanceSteps(Instant from, Duration step, std::int64_t count,
                    std::span<double> all) override {
    const Signals values(all);
    step_ = seconds(from, from + step);
    while (count > 0) {
      const std::int64_t steps = std::min(count, freeSteps(values));
      steps > 0 ? moveFreely(steps, values) : move(step_, values);
      count -= std::max<std::int64_t>(steps, 1);
    }
    show(values);
  }

  double silence(Seen values) const override {
    if (!sameWishes(values)) return 0;
    const double silence = belt_.silence(speed(values));
    if (values["AUTO"] == 0) return silence;
    // A box is put on the belt when the step begins at whose end it is time for that.
    const double toBarriers = std::max(Belt::timeToBarriers(speed(values)) - step_, 0.0);
    return std::min(silence, std::max(interval_ - waited_, 0.0) + toBarriers);
  }

 private:
  template <typename Values>
  bool sameWishes(const Values& values) const {
    for (std::size_t i = 0; i < kSizes.size(); ++i)
      if ((values.from("NEW_SMALL")[i] != 0) != wanted_[i]) return false;
    return true;
  }
  // In so many steps surely no box is put on the belt.
  std::int64_t freeSteps(const Signals& values) const {
    if (!sameWishes(values)) return 0;
    if (values["AUTO"] == 0) return std::numeric_limits<std::int64_t>::max();
    return static_cast<std::int64_t>(std::max(interval_ - waited_ - kUnsure, 0.0) / step_);
  }
  void moveFreely(std::int64_t steps, const Signals& values) {
    waited_ = addRepeatedly(waited_, step_, steps);
    belt_.move(step_, speed(values), slidersOut(values), steps);
  }

  void move(double time, const Signals& values) {
    putByHand(values);
    waited_ += time;
    if (values["AUTO"] != 0 && waited_ >= interval_) putNext();
    belt_.move(time, speed(values), slidersOut(values));
  }

  template <typename Values>
  double speed(const Values& values) const {
    return values["BELT"] * values["SPEED"] / 100 * speed_;
  }
  template <typename Values>
  static std::array<bool, Belt::kSliders> slidersOut(const Values& values) {
    std::array<bool, Belt::kSliders> out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = values.from("SLIDER_SMALL")[i] != 0;
    return out;
  }

  void putByHand(Signals values) {
    for (std::size_t i = 0; i < kSizes.size(); ++i) {
      const bool wanted = values.from("NEW_SMALL")[i] != 0;
      if (wanted && !wanted_[i]) belt_.put(kSizes[i]);
      wanted_[i] = wanted;
    }
  }

  void putNext() {
    if (next_ == 0) shuffle();
    if (!belt_.put(order_[next_])) return;
    next_ = (next_ + 1) % order_.size();
    waited_ = 0;
  }

  // With the generator's numbers as they are, so that a seed means the same everywhere.
  void shuffle() {
    for (std::size_t i = order_.size() - 1; i > 0; --i)
      std::swap(order_[i], order_[random_() % (i + 1)]);
  }

  void show(Signals values) const {
    const Belt::Counts& counts = belt_.counts();
    values["GOOD"] = counts.good;
    values["WRONG"] = counts.wrong;
    for (std::size_t i = 0; i < Belt::kSliders; ++i) {
      values.from("BARRIER_SMALL")[i] = !belt_.interrupted(kSizes[i]);
      values.from("BIN_SMALL")[i] = counts.bins[i];
      values.from("STROKE_SMALL")[i] = belt_.stroke(i);
    }
    auto value = values.from("BOX1").begin();
    for (const Box& box : belt_.boxes()) {
      *value++ = static_cast<double>(box.size);
      *value++ = box.front;
      *value++ = box.pushed;
    }
  }

  double speed_, interval_, automatic_;
  double waited_;    // s since the last box of AUTO
  double step_ = 1;  // s; until there has been one, the longest that can be set
  std::mt19937 random_;
  Belt belt_;
  std::array<BoxSize, 3> order_ = kSizes;
  std::size_t next_ = 0;
  std::array<bool, 3> wanted_{};
};

}  // namespace

const Kind kSortingPlant{"sorting plant", Duration::milliseconds(1), kParameters, kSignals,
                         make<SortingPlant>};

}  // namespace merker::plant
