// Runs by their numbers, and their parts for several machines.
#include "campaign/expansion.h"

#include <gtest/gtest.h>

namespace merker::campaign {
namespace {

Parameter listed(const std::string& name, std::vector<std::string> texts) {
  Parameter parameter{name, {}, {}, {}};
  for (std::string& text : texts) parameter.values.push_back({{std::move(text), {}}, {}});
  return parameter;
}

Definition example() {
  Definition definition;
  definition.repeat = 3;
  definition.firstSeed = 5;
  definition.parameters = {listed("a", {"1", "2"}),
                           listed("b", {"x", "y"}),
                           {"c", {}, {}, Draw{Draw::Kind::Uniform, 0, 1}}};
  return definition;
}

TEST(Expansion, TheSeedChangesQuickestTheFirstParameterSlowest) {
  const Definition definition = example();
  ASSERT_EQ(definition.runs(), 12u);
  std::string order;
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Choice choice = choiceAt(definition, i);
    order += choice.values[0].text + choice.values[1].text + std::to_string(choice.seed) + ' ';
  }
  EXPECT_EQ(order, "1x5 1x6 1x7 1y5 1y6 1y7 2x5 2x6 2x7 2y5 2y6 2y7 ");
}

TEST(Expansion, ADrawnValueIsThatOfItsSeedWhateverElseVaries) {
  const Definition definition = example();
  EXPECT_EQ(choiceAt(definition, 0).values[2], choiceAt(definition, 9).values[2]);
  EXPECT_NE(choiceAt(definition, 0).values[2], choiceAt(definition, 1).values[2]);
}

TEST(Expansion, EachRunIsInOneShard) {
  for (const std::uint64_t count : {1u, 2u, 7u, 16u})
    for (std::uint64_t run = 0; run < 100; ++run) {
      int found = 0;
      for (std::uint64_t number = 1; number <= count; ++number)
        found += Shard{number, count}.has(run);
      EXPECT_EQ(found, 1);
    }
}

TEST(Expansion, AShardIsWrittenAsAFraction) {
  const auto shard = parseShard("3/16");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->number, 3u);
  EXPECT_EQ(shard->count, 16u);
  for (const char* text : {"", "3", "0/2", "3/2", "3/", "/2", "1/2x", "-1/2", "1/1000001", "a/b"})
    EXPECT_FALSE(parseShard(text)) << text;
}

TEST(Expansion, ARunIsDescribedByItsValues) {
  EXPECT_EQ(describe(example(), choiceAt(example(), 0)).substr(0, 12), "a=1, b=x, c=");
  EXPECT_EQ(describe({}, {}), "one run");
}

}  // namespace
}  // namespace merker::campaign
