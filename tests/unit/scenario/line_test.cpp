#include "scenario/line.h"

#include <gtest/gtest.h>

namespace merker::simulator {
namespace {

using List = std::vector<std::string_view>;

TEST(Line, ListsAreCutAtCommasOutsideOfQuotesAndBrackets) {
  EXPECT_EQ(splitList("E 0.0 = 1, \"a, b\" = 1"), (List{"E 0.0 = 1", "\"a, b\" = 1"}));
  EXPECT_EQ(splitList("DB1.a[1,2] = B#(1,2), MB 1 = ','"),
            (List{"DB1.a[1,2] = B#(1,2)", "MB 1 = ','"}));
  EXPECT_EQ(splitList(""), (List{""}));
  EXPECT_EQ(splitList("a,"), (List{"a", ""}));
}

// S5-NUM-05: the two bytes of KY are one constant.
TEST(Line, TheCommaOfKyCutsNothing) {
  EXPECT_EQ(splitList("MW 100 = KY 1,2, MW 2=ky 003, 004,KY 5,6"),
            (List{"MW 100 = KY 1,2", "MW 2=ky 003, 004", "KY 5,6"}));
  EXPECT_EQ(splitList("KY 1,MW 2"), (List{"KY 1", "MW 2"}));
  EXPECT_EQ(splitList("-SKY 1,2"), (List{"-SKY 1", "2"}));
  EXPECT_EQ(splitList("MW 1,2"), (List{"MW 1", "2"}));
}

TEST(Line, ACommentBeginsAfterABlank) {
  EXPECT_EQ(withoutComment("  set MW 2 = W#16#5  # five"), "set MW 2 = W#16#5");
  EXPECT_EQ(withoutComment("# all"), "");
  EXPECT_EQ(withoutComment("wait 5ms\t# tab"), "wait 5ms");
  EXPECT_EQ(withoutComment("scenario \"a # b\""), "scenario \"a # b\"");
  EXPECT_EQ(withoutComment("set \"x\" = S5T#5S # 5"), "set \"x\" = S5T#5S");
}

TEST(Line, Words) {
  std::string_view text = "  cold \t restart now ";
  EXPECT_EQ(takeWord(text), "cold");
  EXPECT_EQ(takeWord(text), "restart");
  EXPECT_EQ(text, "now");
  EXPECT_EQ(takeWord(text), "now");
  EXPECT_EQ(takeWord(text), "");
}

}  // namespace
}  // namespace merker::simulator
