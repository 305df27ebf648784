// The sorting plant (S7-VIS-07 to S7-VIS-16).
#include <gtest/gtest.h>

#include "make.h"

namespace merker::plant {
namespace {

Bench belt(std::vector<Given> given = {}) {
  return Bench(make("Belt", "sorting plant", std::move(given)));
}

void put(Bench& bench, std::string_view button) {
  bench.set(button, 1);
  bench.set(button, 0);
}

void push(Bench& bench, std::string_view slider) {
  bench.set(slider, 1);
  bench.wait(Duration::seconds(1));
  bench.set(slider, 0);
}

// S7-VIS-10: 0 while the box is there; from 2.0 s (20 cm) to 2.8 s (its length).
TEST(SortingPlant, barriersFollowTheBox) {
  Bench bench = belt();
  put(bench, "NEW_MIDDLE");
  bench.go(at(1999));
  EXPECT_EQ(bench.value("BARRIER_SMALL"), 1);
  bench.go(at(2002));
  EXPECT_EQ(bench.value("BARRIER_SMALL"), 0);
  EXPECT_EQ(bench.value("BARRIER_MIDDLE"), 0);
  EXPECT_EQ(bench.value("BARRIER_LARGE"), 1);
  bench.go(at(2798));
  EXPECT_EQ(bench.value("BARRIER_SMALL"), 0);
  bench.go(at(2802));
  EXPECT_EQ(bench.value("BARRIER_SMALL"), 1);
}

// S7-VIS-12 to S7-VIS-14, S7-VIS-16: within 0.2 s the slider hits, and only that one.
TEST(SortingPlant, slidersHitAtTheirTime) {
  struct Case {
    std::string_view button, slider;
    int ms;
  };
  for (const Case& c :
       {Case{"NEW_SMALL", "SLIDER_SMALL", 3000}, Case{"NEW_MIDDLE", "SLIDER_MIDDLE", 5000},
        Case{"NEW_LARGE", "SLIDER_LARGE", 7000}}) {
    for (const int speed : {100, 50}) {
      for (const int late : {-1000, -200, 0, 200, 1000}) {
        Bench bench = belt();
        bench.set("SPEED", speed);
        put(bench, c.button);
        bench.wait(Duration::milliseconds((2800 + c.ms + late) * 100 / speed));
        push(bench, c.slider);
        bench.wait(Duration::seconds(20));
        EXPECT_EQ(bench.value("GOOD"), std::abs(late) < 500) << c.slider << speed << late;
        EXPECT_EQ(bench.value("WRONG"), std::abs(late) > 500) << c.slider << speed << late;
      }
    }
  }
}

// A box within 3 cm of the middle of the slider goes into the bin; one that its plate (8 cm) still
// touches falls off the belt; one beside it (8 cm and more, the box is 8 cm long) stays there.
TEST(SortingPlant, aBoxBesideTheSliderFallsOff) {
  struct Case {
    int beside;  // mm
    int good, wrong;
  };
  for (const Case& c : {Case{0, 1, 0}, Case{29, 1, 0}, Case{-29, 1, 0}, Case{32, 0, 1},
                        Case{-32, 0, 1}, Case{40, 0, 1}, Case{-40, 0, 1}, Case{78, 0, 1},
                        Case{-78, 0, 1}, Case{82, 0, 0}, Case{-82, 0, 0}}) {
    Bench bench = belt();
    put(bench, "NEW_SMALL");
    const auto front = [&] {
      for (const char number : {'1', '2', '3', '4', '5', '6'})
        if (bench.value(std::string("BOX") + number) == 1)
          return bench.value(std::string("FRONT") + number);
      return -1.0;
    };
    const double wanted = 0.35 + 0.04 + c.beside / 1000.0;  // its front, half a box ahead
    while (front() < wanted) bench.wait(Duration::milliseconds(1));
    bench.set("BELT", 0);
    push(bench, "SLIDER_SMALL");
    bench.wait(Duration::seconds(1));
    EXPECT_EQ(bench.value("GOOD"), c.good) << c.beside;
    EXPECT_EQ(bench.value("WRONG"), c.wrong) << c.beside;
  }
}

TEST(SortingPlant, aWrongSliderIsWrong) {
  Bench bench = belt();
  put(bench, "NEW_LARGE");
  bench.go(at(5800));
  push(bench, "SLIDER_SMALL");
  EXPECT_EQ(bench.value("BIN_SMALL"), 1);
  EXPECT_EQ(bench.value("WRONG"), 1);
  EXPECT_EQ(bench.value("GOOD"), 0);
}

TEST(SortingPlant, boxesQueueBeforeASliderThatIsOut) {
  Bench bench = belt();
  bench.set("SLIDER_SMALL", 1);
  put(bench, "NEW_SMALL");
  bench.wait(Duration::seconds(2));
  put(bench, "NEW_LARGE");
  bench.wait(Duration::seconds(30));
  // The plate is 8 cm wide around 35 cm; one box behind the other.
  double first = 0, second = 0;
  for (const char number : {'1', '2', '3', '4', '5', '6'}) {
    const double size = bench.value(std::string("BOX") + number);
    if (size == 1) first = bench.value(std::string("FRONT") + number);
    if (size == 3) second = bench.value(std::string("FRONT") + number);
  }
  EXPECT_NEAR(first, 0.31, 1e-9);
  EXPECT_NEAR(second, 0.23, 1e-9);
  EXPECT_EQ(bench.value("WRONG"), 0);
}

TEST(SortingPlant, thereIsNoRoomForTwoBoxes) {
  Bench bench = belt();
  bench.set("BELT", 0);
  put(bench, "NEW_SMALL");
  put(bench, "NEW_SMALL");
  bench.set("BELT", 1);
  bench.wait(Duration::seconds(20));
  EXPECT_EQ(bench.value("WRONG"), 1);
}

// Each three boxes have one of each size, the same seed gives the same order.
TEST(SortingPlant, boxesByThemselves) {
  Bench one = belt({{"automatic", 1}, {"seed", 3}});
  Bench same = belt({{"automatic", 1}, {"seed", 3}});
  int sizes[4] = {};
  for (int i = 0; i < 9; ++i) {
    for (Bench* it : {&one, &same}) it->go(at(3300 + 10000 * i));  // in the barriers
    const int beams[] = {one.value("BARRIER_SMALL") == 0, one.value("BARRIER_MIDDLE") == 0,
                         one.value("BARRIER_LARGE") == 0};
    ++sizes[beams[0] + beams[1] + beams[2]];
    EXPECT_EQ(one.value("BARRIER_LARGE"), same.value("BARRIER_LARGE"));
  }
  EXPECT_EQ(sizes[0], 0);
  for (const int size : {1, 2, 3}) EXPECT_EQ(sizes[size], 3);
}

}  // namespace
}  // namespace merker::plant
