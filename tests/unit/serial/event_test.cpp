// The numbers at STATUS against the requirements.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "serial/events.h"

namespace merker::serial {
namespace {

std::set<unsigned> printed() {
  std::ifstream file(MERKER_SOURCE_DIR "/docs/requirements/technology-ptp.md");
  std::set<unsigned> numbers;
  const std::regex row(R"(^\| PTP-ERR-\d+ \| ([0-9A-F]{4})H:.*)");
  std::smatch match;
  for (std::string line; std::getline(file, line);)
    if (std::regex_match(line, match, row))
      numbers.insert(static_cast<unsigned>(std::stoul(match[1], nullptr, 16)));
  return numbers;
}

// PTP-ERR-65, SFBG-08
TEST(SerialEvents, AreThoseOfTheManualAndFourOfTheCp341) {
  std::set<unsigned> wanted = printed(), found;
  EXPECT_EQ(wanted.size(), 63U);
  wanted.insert({0x0610, 0x0611, 0x090B, 0x0A01});
  for (const EventText& row : events()) {
    EXPECT_TRUE(found.insert(static_cast<unsigned>(row.event)).second);
    EXPECT_FALSE(row.text.empty());
  }
  EXPECT_EQ(found, wanted);
}

// SFBG-07
TEST(SerialEvents, ClassInTheHighByte) {
  for (const EventText& row : events()) {
    const unsigned eventClass = static_cast<unsigned>(row.event) >> 8U;
    EXPECT_TRUE(eventClass == 3 || (eventClass >= 5 && eventClass <= 11));
  }
  EXPECT_EQ(static_cast<unsigned>(Event::Restarted), 0x0501U);
}

// PTP-ERR-64, SFBG-09
TEST(SerialEvents, WarningsAreFour) {
  std::set<unsigned> warnings;
  for (const EventText& row : events())
    if (isWarning(row.event)) warnings.insert(static_cast<unsigned>(row.event));
  EXPECT_EQ(warnings, (std::set<unsigned>{0x0701, 0x0801, 0x0807, 0x0B01}));
}

}  // namespace
}  // namespace merker::serial
