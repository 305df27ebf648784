// Pictures of results: which values lie where.
#include "campaign/picture.h"

#include <gtest/gtest.h>

#include "campaign/scale.h"

namespace merker::campaign {
namespace {

ResultTable sampleTable() {
  ResultTable table{"Test < 1", {"a", "engine", "seed"}, {"m", "n"}, {}};
  for (int a = 1; a <= 3; ++a)
    for (int seed = 1; seed <= 5; ++seed)
      table.rows.push_back(
          {{valueOf(a), {seed % 2 == 0 ? "jit" : "interpreter", {}}, valueOf(seed)},
           {a * 10.0 + seed, std::nullopt}});
  return table;
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

TEST(Scale, HasEachValueOnceInOrder) {
  ResultTable table = sampleTable();
  std::swap(table.rows.front(), table.rows.back());
  const Scale scale = scaleOf(table, 0);
  EXPECT_TRUE(scale.numbers);
  EXPECT_EQ(scale.places, (std::vector<Value>{valueOf(1), valueOf(2), valueOf(3)}));
  EXPECT_EQ(scale.placeOf(valueOf(3)), 2u);
  EXPECT_FALSE(scaleOf(table, 1).numbers);
}

TEST(Scale, DividesManyNumbers) {
  ResultTable table{"", {"a"}, {}, {}};
  for (int i = 0; i <= 100; ++i) table.rows.push_back({{valueOf(i)}, {}});
  const Scale scale = scaleOf(table, 0);
  ASSERT_EQ(scale.places.size(), kParts);
  EXPECT_EQ(scale.places[0].number, 2.5);
  EXPECT_EQ(scale.placeOf(valueOf(0)), 0u);
  EXPECT_EQ(scale.placeOf(valueOf(5)), 1u);
  EXPECT_EQ(scale.placeOf(valueOf(100)), kParts - 1);
}

TEST(Picture, HasAMedianAndTwoBands) {
  const auto picture = draw(sampleTable(), {}, "a.sqlite");
  ASSERT_TRUE(picture);
  EXPECT_NE(picture->find("Test &lt; 1"), std::string::npos);
  EXPECT_EQ(count(*picture, "<circle"), 3u);
  EXPECT_EQ(count(*picture, "fill-opacity"), 2u);
}

TEST(Picture, HasACurveForEachValueOfAnother) {
  const auto picture = draw(sampleTable(), {"", "a", "m", "engine", ""}, "a.sqlite");
  ASSERT_TRUE(picture);
  EXPECT_EQ(count(*picture, "<circle"), 6u);
  EXPECT_NE(picture->find("engine = jit"), std::string::npos);
}

TEST(Picture, IsAMapOfMedians) {
  const auto picture = draw(sampleTable(), {"", "a", "engine", "", "m"}, "a.sqlite");
  ASSERT_TRUE(picture);
  for (const char* median : {">13<", ">23<", ">33<"})
    EXPECT_EQ(count(*picture, median), 2u) << median;
}

TEST(Picture, IsDrawnWithoutValues) {
  EXPECT_TRUE(draw(sampleTable(), {"", "", "n", "", ""}, "a.sqlite"));
  EXPECT_TRUE(draw(sampleTable(), {"", "", "", "", "n"}, "a.sqlite"));
}

TEST(Picture, NamesWhatThereIs) {
  const auto unknown = draw(sampleTable(), {"", "b", "", "", ""}, "a.sqlite");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ProblemCode::P0787);
  EXPECT_NE(unknown.error().message.find("a, engine, seed"), std::string::npos);
  EXPECT_EQ(draw(ResultTable{}, {}, "a.sqlite").error().code, ProblemCode::P0786);
}

}  // namespace
}  // namespace merker::campaign
