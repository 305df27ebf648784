#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

// S7-DIAG-01: newest first, plain text, and the line that "open block" opens.
TEST(DiagnosticList, LeadsToTheFaultyLine) {
  Plc plc(kProgram);
  plc.start();
  EXPECT_EQ(name(plc->write("M 0.0", "1")), "good");
  plc.run();
  const auto lines = plc->diagnostics();
  ASSERT_GE(lines.size(), 4u);
  EXPECT_EQ(lines[0].number, 1u);
  EXPECT_EQ(lines[0].event, 0x4562);
  EXPECT_EQ(lines[1].event, 0x253A);
  EXPECT_NE(lines[1].text.find("DB 99"), std::string::npos);
  ASSERT_TRUE(lines[1].place.has_value());
  EXPECT_EQ(lines[1].place->file, "plant.awl");
  EXPECT_EQ(lines[1].place->line, 26u);
  EXPECT_FALSE(lines[1].help.empty());
  EXPECT_FALSE(lines.back().place.has_value());
}

// S7-DIAG-01: an entry keeps the DATE_AND_TIME of its event, also when the clock is set later.
TEST(DiagnosticList, KeepsTheTimeOfTheEvent) {
  Plc plc(kProgram);
  plc.start();
  plc.station().advanceCycles(2);
  const auto before = plc->diagnostics();
  ASSERT_FALSE(before.empty());
  plc.station().cpu().setClock(1'000'000'000'000);
  const auto after = plc->diagnostics();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].clock, before[i].clock);
  plc.station().stop();
  EXPECT_EQ(plc->diagnostics()[0].clock.value_or(0) / 1000, 1'000'000'000);
}

// S7-DIAG-03: every reason for STOP through a fault has its help.
TEST(DiagnosticList, HelpsWithEveryReasonForStop) {
  for (const unsigned event :
       {0x4562, 0x4563, 0x4568, 0x456A, 0x456B, 0x456C, 0x456D, 0x456E, 0x456F, 0x4570, 0x4571,
        0x4572, 0x4573, 0x4574, 0x4575, 0x4576, 0x4578, 0x457A})
    EXPECT_FALSE(diagnosticHelp(static_cast<std::uint16_t>(event)).empty()) << std::hex << event;
  EXPECT_TRUE(diagnosticHelp(0x4302).empty());
}

// S7-DIAG-02: each synchronous error, and what stands beside a STOP.
TEST(DiagnosticList, HelpsWithEveryError) {
  for (const unsigned event :
       {0x2521, 0x2522, 0x2523, 0x2524, 0x2525, 0x2526, 0x2527, 0x2528, 0x2529,
        0x2530, 0x2531, 0x2532, 0x2533, 0x2534, 0x2535, 0x253A, 0x253C, 0x253D,
        0x253E, 0x253F, 0x2942, 0x2943, 0x3501, 0x3502, 0x3842, 0x3942})
    EXPECT_FALSE(diagnosticHelp(static_cast<std::uint16_t>(event)).empty()) << std::hex << event;
}

TEST(ModuleInformation, ShowsTheState) {
  Plc plc(kProgram);
  EXPECT_EQ(plc->information().mode, station::Mode::Stop);
  plc.start();
  plc.station().advanceCycles(3);
  const ModuleInformation info = plc->information();
  EXPECT_EQ(info.model, "CPU 314C-2 PtP");
  EXPECT_EQ(info.mode, station::Mode::Run);
  EXPECT_EQ(info.cycles, 3u);
  EXPECT_EQ(info.blocks, 2u);
  EXPECT_GT(info.workMemoryUsed, 0u);
  EXPECT_EQ(clockText(0), "1990-01-01 00:00:00.000");
  EXPECT_EQ(clockText(((59ll * 86400) + 3661) * 1000 + 7), "1990-03-01 01:01:01.007");
}

}  // namespace
}  // namespace merker::monitor::test
