// Drawn values are the same everywhere. The expected ones come from Python: hashlib and
// statistics.NormalDist.
#include "campaign/draw.h"

#include <gtest/gtest.h>

#include "campaign/digest.h"

namespace merker::campaign {
namespace {

TEST(Digest, IsSha256) {
  Digest digest;
  digest.add("ab");
  digest.add("c");  // FIPS 180-2, B.1
  EXPECT_EQ(digest.text(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, TwoPartsAreNotOne) {
  Digest one, two;
  one.addPart("ab");
  one.addPart("c");
  two.addPart("a");
  two.addPart("bc");
  EXPECT_NE(one.text(), two.text());
}

TEST(Draw, DependsOnSeedAndNameAlone) {
  EXPECT_EQ(evenly(1, "plant.Vessel.stroke"), 0.4193432028057379);
  EXPECT_EQ(evenly(2, "plant.Vessel.stroke"), 0.47805899300121457);
  EXPECT_EQ(plantSeed(1, "plant.Oven.seed"), 396319685u);
}

TEST(Draw, IsEvenOrNormal) {
  EXPECT_EQ(drawn({Draw::Kind::Uniform, 0.8, 1.2}, 1, "plant.Vessel.stroke"), 0.967737281);
  EXPECT_EQ(drawn({Draw::Kind::Normal, 80, 6}, 1, "plant.Vessel.stroke"), 78.7785559);
  EXPECT_EQ(drawn({Draw::Kind::Normal, 80, 0}, 1, "plant.Vessel.stroke"), 80);
}

TEST(Draw, TheNormalDistributionHasItsQuantiles) {
  EXPECT_NEAR(normalQuantile(0.975), 1.9599639845400536, 1e-14);
  EXPECT_NEAR(normalQuantile(1e-10), -6.361340902404056, 1e-13);
  EXPECT_EQ(normalQuantile(0.5), 0);
  for (const double p : {0.01, 0.06, 0.08, 0.3})
    EXPECT_NEAR(normalQuantile(p), -normalQuantile(1 - p), 1e-13);
}

TEST(Draw, ManySeedsHaveTheMeanAndTheDeviation) {
  double sum = 0, squares = 0;
  constexpr int kSeeds = 10'000;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const double value = drawn({Draw::Kind::Normal, 0, 1}, static_cast<std::uint64_t>(seed), "x");
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kSeeds, 0, 0.04);
  EXPECT_NEAR(squares / kSeeds, 1, 0.06);
}

TEST(Draw, ARangeHasShortNumbers) { EXPECT_EQ(shortened(0.8 + 0.05000000000000001), 0.85); }

}  // namespace
}  // namespace merker::campaign
