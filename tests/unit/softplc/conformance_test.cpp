// The self-checking listings of tests/conformance/step5.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

std::vector<std::filesystem::path> listings() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(MERKER_SOURCE_DIR "/tests/conformance/step5"))
    if (entry.path().extension() == ".s5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class Conformance : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Conformance, Holds) {
  ListingBench b(contents(GetParam()));
  b.set(2003, 1, false);  // as long as it takes
  b.run(10'000);
  EXPECT_EQ(b.plc().mode(), Mode::Stop);
  EXPECT_FALSE(b.plc().stoppedByFault()) << b.plc().stopReason();
  EXPECT_EQ(b.shownAlarm(), number(Alarm::Stp)) << b.plc().stopReason();
  EXPECT_FALSE(b.plc().checkResults().empty());
  for (const CheckResult& result : b.plc().checkResults()) {
    EXPECT_GT(result.reached, 0u) << "line " << result.check->position.line;
    for (const CheckFailure& failure : result.failures)
      ADD_FAILURE() << "line " << result.check->position.line << ": " << failure.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Step5, Conformance, testing::ValuesIn(listings()),
                         [](const auto& tested) { return tested.param.stem().string(); });

}  // namespace
}  // namespace merker::sinumerik
