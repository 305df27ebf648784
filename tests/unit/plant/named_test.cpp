// Signals and parameters by name: found in the rows while Merker is compiled, and a name that no
// row has does not compile.
#include "plant/named.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

namespace merker::plant {
namespace {

constexpr Parameter kParameters[] = {{"capacity"}, {"start"}};
constexpr Signal kSignals[] = {{"INFLOW"}, {"BOX1"}, {"BOX2"}, {"LEVEL"}};

template <std::size_t size>
struct Text {
  char text[size];
  consteval Text(const char (&literal)[size]) {
    for (std::size_t i = 0; i < size; ++i) text[i] = literal[i];
  }
};

// True if a value can be asked for by this name.
template <const auto& rows, Text name>
concept Compiles = requires {
  typename std::integral_constant<std::uint32_t, RowName<rows>(name.text).index>;
};

static_assert(Compiles<kSignals, "LEVEL"> && Compiles<kParameters, "start">);
static_assert(!Compiles<kSignals, "LEVL">);
static_assert(!Compiles<kSignals, "level">);
static_assert(!Compiles<kSignals, "BOX">);
static_assert(!Compiles<kSignals, "start">);  // a parameter
static_assert(!Compiles<kNoParameters, "start">);

static_assert(areTogether(kSignals, "BOX1", "BOX2", 2));
static_assert(!areTogether(kSignals, "INFLOW", "BOX2", 2));
static_assert(!areTogether(kSignals, "BOX2", "BOX1", 2));

TEST(Named, ValuesOfTheRows) {
  std::vector<double> values{10, 11, 12, 13};
  const Named<kSignals, double> signals{values};
  EXPECT_EQ(signals["INFLOW"], 10);
  EXPECT_EQ(signals["LEVEL"], 13);
  EXPECT_EQ(signals.from("BOX1")[1], 12);
  EXPECT_EQ(signals.at("BOX2"), 2u);
  signals["LEVEL"] = 5;
  EXPECT_EQ(values[3], 5);
}

}  // namespace
}  // namespace merker::plant
