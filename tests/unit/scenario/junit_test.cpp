#include "scenario/junit.h"

#include <gtest/gtest.h>

#include <sstream>

namespace merker::simulator {
namespace {

std::string written(const std::vector<TestResult>& results) {
  std::ostringstream out;
  writeJunit(results, out);
  return out.str();
}

TEST(Junit, SuitesCasesAndFailures) {
  const TestResult good{"a.scn", "first", {1'500'000'000}, {}};
  const TestResult bad{"a.scn",
                       "second <&\">",
                       {2'000'000'000},
                       {{{"a.scn", 7, 3, 5}, {6'800'000'000}, "expected 1\x01"}}};
  EXPECT_EQ(
      written({good, bad}),
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"2\" failures=\"1\">\n"
      "  <testsuite name=\"a.scn\" tests=\"2\" failures=\"1\" errors=\"0\" time=\"3.500000\">\n"
      "    <testcase classname=\"a.scn\" name=\"first\" time=\"1.500000\"/>\n"
      "    <testcase classname=\"a.scn\" name=\"second &lt;&amp;&quot;&gt;\" time=\"2.000000\">\n"
      "      <failure message=\"expected 1 \">a.scn:7: at 6.800 s: expected 1 </failure>\n"
      "    </testcase>\n"
      "  </testsuite>\n"
      "</testsuites>\n");
}

TEST(Junit, AFailureOfTheWholeFileHasNoLine) {
  EXPECT_EQ(describe({{"a.awl", 0, 0}, {0}, "STOP"}), "a.awl: at 0.000 s: STOP");
}

}  // namespace
}  // namespace merker::simulator
