// What plants say of the time in which their switches stay as they are: never too long.
#include "plant/silence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "make.h"

namespace merker::plant {
namespace {

constexpr Duration kMillisecond = Duration::milliseconds(1);

class Unattended {
 public:
  Unattended(const Kind& kind, std::uint32_t seed) : kind_(kind), random_(seed) {
    for (const Parameter& row : kind.parameters) parameters_.push_back(row.standard);
    process_ = kind.make(parameters_);
    for (const Signal& signal : kind.signals) values_.push_back(signal.rest);
    process_->begin(values_);
  }
  void changeInputs() {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const Signal& signal = kind_.signals[i];
      if (signal.side != Signal::Side::Input || random_() % 4 != 0) continue;
      values_[i] = signal.binary ? static_cast<double>(random_() % 2)
                                 : signal.low + (signal.high - signal.low) * random_() / 4294967295;
    }
  }
  void step() {
    process_->advance(now_, now_ + kMillisecond, values_);
    now_ = now_ + kMillisecond;
  }
  std::vector<double> switches() const {
    std::vector<double> all;
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (kind_.signals[i].side == Signal::Side::Output && kind_.signals[i].binary)
        all.push_back(values_[i]);
    return all;
  }
  // Whole steps that are said to be silent.
  int silentSteps() const {
    constexpr double kMost = 0.5;  // s
    return static_cast<int>((std::min(process_->silence(values_), kMost) - kUnsure) * 1000);
  }

 private:
  const Kind& kind_;
  std::mt19937 random_;
  std::vector<double> parameters_, values_;
  std::unique_ptr<Process> process_;
  Instant now_;
};

TEST(Silence, isNeverTooLong) {
  std::set<std::string_view> silent;
  for (const Kind* kind : kinds())
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      Unattended it(*kind, seed);
      for (int round = 0; round < 40; ++round) {
        it.changeInputs();
        if (it.silentSteps() <= 0) it.step();
        const std::vector<double> now = it.switches();
        for (int left = it.silentSteps(); left > 0; --left) {
          it.step();
          silent.insert(kind->name);
          ASSERT_EQ(it.switches(), now) << kind->name << ", seed " << seed << ", round " << round;
        }
      }
    }
  EXPECT_EQ(silent, (std::set<std::string_view>{"garage door", "lift", "sorting plant", "tank",
                                                "traffic light", "valve", "vessel"}));
}

// So slow that floating point decides whether it moves at all.
TEST(Silence, ofWhatHardlyMovesIsUnknown) {
  EXPECT_EQ(secondsTo(100, 50, 1e-9), 0);
  EXPECT_EQ(secondsTo(100, 50, 0), kForever);
  EXPECT_EQ(secondsTo(100, 50, 10), 5);
  EXPECT_EQ(secondsTo(100, 50, -10), kForever);
  EXPECT_EQ(secondsTo({0, 100}, 100, 10, 0, 100), kForever);
  EXPECT_EQ(secondsTo({0, 100}, 100, -10, 0, 100), 0);
}

}  // namespace
}  // namespace merker::plant
