#include <gtest/gtest.h>

#include "compilation/build.h"

namespace merker::compilation {
namespace {

const std::string kInstances =
    "DATA_BLOCK DB 20\nSFB 60\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 21\nSFB 60\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 30\nSFB 46\nBEGIN\nEND_DATA_BLOCK\n";

std::string ob(int number, const std::string& statements) {
  return "ORGANIZATION_BLOCK OB " + std::to_string(number) +
         "\nVAR_TEMP\ninfo : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n" + statements +
         "END_ORGANIZATION_BLOCK\n";
}

// Code and text of each warning, with the lines of `text` counted behind the instances.
std::vector<std::string> warnings(const std::string& text,
                                  const std::string& instances = kInstances) {
  const Build build =
      compilation::build(project::load("a.awl", {}, {{"a.awl", instances + text}}, {}), false);
  EXPECT_TRUE(build.ok());
  std::vector<std::string> result;
  const auto before = std::ranges::count(instances, '\n');
  for (const Problem& problem : build.problems.list())
    result.push_back(std::to_string(problem.position.line - before) + " " +
                     std::string(problem.name()) + " " + problem.message);
  return result;
}

using Texts = std::vector<std::string>;

// PTP-SFBG-01
TEST(SystemBlockCalls, ASecondInstanceOfTheSerialInterface) {
  EXPECT_EQ(warnings(ob(1, "CALL SFB 60, DB 20;\nCALL SFB 60, DB 20;\n")), Texts{});
  EXPECT_EQ(warnings(ob(1, "CALL SFB 60, DB 20;\nCALL SFB 60, DB 21;\n")),
            Texts{"8 P0523 SFB 60 is called with DB 20 as well; all its calls must use the same "
                  "instance data block"});
}

// POS-OVW-20, PTP-SFBG-03: also below other blocks.
TEST(SystemBlockCalls, TheSameInTwoPriorityClasses) {
  const std::string below =
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nCALL SFB 46, DB 30;\nEND_FUNCTION\n";
  const Texts found = warnings(below + ob(1, "UC FC 1;\n") + ob(35, "UC FC 1;\n"));
  EXPECT_EQ(found, Texts{"4 P0524 SFB 46 is called in OB 1 and in OB 35, which can interrupt it; "
                         "all calls of an SFB must be in one priority class"});
}

// The start-up is over before OB 1 begins; timers of the CPU are no technological function.
TEST(SystemBlockCalls, WhatIsAllowed) {
  EXPECT_EQ(warnings(ob(1, "CALL SFB 46, DB 30;\n") + ob(100, "CALL SFB 46, DB 30;\n")), Texts{});
  EXPECT_EQ(warnings("DATA_BLOCK DB 40\nSFB 4\nBEGIN\nEND_DATA_BLOCK\n" +
                     ob(1, "CALL SFB 4, DB 40;\n") + ob(35, "CALL SFB 4, DB 40;\n")),
            Texts{});
}

// Blocks that call each other in a ring are searched once.
TEST(SystemBlockCalls, ARing) {
  const auto function = [](int number, const std::string& text) {
    return "FUNCTION FC " + std::to_string(number) + " : VOID\nBEGIN\nNETWORK\n" + text +
           "END_FUNCTION\n";
  };
  EXPECT_EQ(warnings(function(1, "CALL SFB 46, DB 30;\nUC FC 2;\n") + function(2, "UC FC 1;\n") +
                     ob(1, "UC FC 2;\n"))
                .size(),
            0u);
}

// A multiple instance has no data block of its own, but a priority class.
TEST(SystemBlockCalls, MultipleInstances) {
  const std::string sender =
      "FUNCTION_BLOCK FB 1\nVAR\naxis : SFB 46;\nEND_VAR\nBEGIN\nNETWORK\nCALL #axis;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string call = "CALL FB 1, DB 1;\n";
  EXPECT_EQ(warnings(sender + ob(1, call), ""), Texts{});
  EXPECT_EQ(warnings(sender + ob(1, call) + ob(40, call), "").size(), 1u);
}

// CNT-IF47-13: each technological SFB of the CPU, and no other.
TEST(SystemBlockCalls, EachTechnologicalBlock) {
  for (const int number : {3, 4, 5, 41, 42, 43, 44, 46, 47, 48, 49, 60, 61, 62, 63, 64, 65}) {
    const std::string sfb = "SFB " + std::to_string(number);
    const std::string call = "CALL " + sfb + ", DB 1;\n";
    const bool technology = number >= 44;
    EXPECT_EQ(warnings("DATA_BLOCK DB 1\n" + sfb + "\nBEGIN\nEND_DATA_BLOCK\n" + ob(1, call) +
                           ob(35, call),
                       "")
                  .size(),
              technology ? 1u : 0u)
        << sfb;
  }
}

}  // namespace
}  // namespace merker::compilation
