// Texts as long as any that is taken.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "graph/edit.h"
#include "networks/source_edit.h"

namespace merker::networks {
namespace {

constexpr std::size_t kNetworks = 20'000;

void expectMany(const std::string& text, const Surroundings& around) {
  const source::SourceFile file("a", text);
  const auto block = blockAt(file, 2, around);
  ASSERT_TRUE(block);
  ASSERT_EQ(block->networks.size(), kNetworks);
  for (const Network& network : block->networks) ASSERT_TRUE(network.tree);
  graph::Edit wish;
  wish.action = graph::Action::Negate;
  wish.at.node = 0;
  const auto done = edit(file, 2, kNetworks, wish, around);
  ASSERT_TRUE(done);
  EXPECT_EQ(done->to, done->from + 1);
}

TEST(Bounds, allowTwentyThousandNetworksInStep7) {
  std::string text = "FUNCTION FC 1 : VOID\nBEGIN\n";
  for (std::size_t i = 0; i < kNetworks; ++i)
    text += fmt::format(
        "NETWORK\nTITLE = network {0}\n// what it does, in a comment of a usual length: the pump\n"
        "      U     E 0.0;\n      U(    ;\n      O     E 0.1;\n      O     E 0.2;\n      )     ;\n"
        "      SPBNB _{0};\n      L     MW 10;\n      T     MW 20;\n_{0}: NOP   0;\n",
        i);
  expectMany(text + "END_FUNCTION\n", {});
}

TEST(Bounds, allowTwentyThousandNetworksInStep5) {
  std::string text = "PB 1\n";
  for (std::size_t i = 1; i <= kNetworks; ++i)
    text += fmt::format("NETZWERK {} title\n : U    E 0.0\n : O    E 0.1\n : =    A 0.0\n", i);
  Surroundings around;
  around.language = source::Language::Step5;
  expectMany(text + " : BE\n", around);
}

// 2,000 parameters, 1,000 calls: two millions would be shown, of which the text names none.
TEST(Bounds, leaveCallsWithoutPictureBehindAHundredThousandParameters) {
  std::string text = "FUNCTION FC 1 : VOID\nVAR_INPUT\n";
  for (int i = 0; i < 2000; ++i) text += fmt::format("A{} : BOOL;\n", i);
  text += "END_VAR\nBEGIN\n";
  for (int i = 0; i < 1000; ++i) text += "NETWORK\nCALL FC 1; NOP 0;\n";
  const auto block = blockAt(source::SourceFile("a.awl", text + "END_FUNCTION\n"), 1, {});
  ASSERT_TRUE(block);
  ASSERT_EQ(block->networks.size(), 1000u);
  EXPECT_TRUE(block->networks[49].tree);
  EXPECT_FALSE(block->networks[50].tree);
  EXPECT_TRUE(block->networks[999].source.statements.front().arguments.empty());
}

}  // namespace
}  // namespace merker::networks
