// SFB 0..5 (S7-SFB-01 … -07).
#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

Plc plcWith(int sfb, std::string_view call) {
  return Plc("DATA_BLOCK DB 1 SFB " + std::to_string(sfb) +
             "\nBEGIN\nEND_DATA_BLOCK\n"
             "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
             std::string(call) + "\nEND_ORGANIZATION_BLOCK\n");
}

void runFor(Plc& plc, int milliseconds) { plc.run(Duration::milliseconds(milliseconds)); }

// S7-SFB-05
TEST(IecTimer, OnDelay) {
  Plc plc = plcWith(4, "CALL SFB 4, DB 1 (IN := E 0.0, PT := T#1S, Q := M 0.0, ET := MD 4);");
  plc.start();
  plc.write("E 0.0", 1);
  runFor(plc, 995);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  EXPECT_NEAR(plc.read("MD 4"), 994, 2);
  runFor(plc, 10);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  runFor(plc, 500);
  EXPECT_EQ(plc.read("MD 4"), 1000u);
  plc.write("E 0.0", 0);
  runFor(plc, 2);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  EXPECT_EQ(plc.read("MD 4"), 0u);
}

// S7-SFB-06
TEST(IecTimer, OffDelay) {
  Plc plc = plcWith(5, "CALL SFB 5, DB 1 (IN := E 0.0, PT := T#1S, Q := M 0.0, ET := MD 4);");
  plc.start();
  runFor(plc, 10);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  plc.write("E 0.0", 1);
  runFor(plc, 10);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  plc.write("E 0.0", 0);
  runFor(plc, 500);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  plc.write("E 0.0", 1);  // IN = 1 resets ET
  runFor(plc, 2);
  EXPECT_EQ(plc.read("MD 4"), 0u);
  plc.write("E 0.0", 0);
  runFor(plc, 990);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  runFor(plc, 20);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  EXPECT_EQ(plc.read("MD 4"), 1000u);
}

// S7-SFB-04
TEST(IecTimer, Pulse) {
  Plc plc = plcWith(3, "CALL SFB 3, DB 1 (IN := E 0.0, PT := T#1S, Q := M 0.0, ET := MD 4);");
  plc.start();
  const auto pulse = [&] {
    plc.write("E 0.0", 1), runFor(plc, 10), plc.write("E 0.0", 0), runFor(plc, 10);
  };
  pulse();
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  runFor(plc, 500);
  pulse();  // without effect
  runFor(plc, 440);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  runFor(plc, 40);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  plc.write("E 0.0", 1);
  runFor(plc, 1500);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  EXPECT_EQ(plc.read("MD 4"), 1000u);
}

// S7-SFB-01
TEST(IecCounter, Up) {
  Plc plc =
      plcWith(0, "CALL SFB 0, DB 1 (CU := E 0.0, R := E 0.1, PV := 2, Q := M 0.0, CV := MW 2);");
  plc.start();
  const auto pulse = [&] {
    plc.write("E 0.0", 1), plc->advanceCycles(2), plc.write("E 0.0", 0), plc->advanceCycles(2);
  };
  pulse();
  EXPECT_EQ(plc.read("MW 2"), 1u);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  pulse();
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  plc.write("DB1.DBW 6", 32767);
  pulse();
  EXPECT_EQ(plc.read("MW 2"), 32767u);
  plc.write("E 0.1", 1);
  pulse();
  EXPECT_EQ(plc.read("MW 2"), 0u);
}

// S7-SFB-02
TEST(IecCounter, Down) {
  Plc plc =
      plcWith(1, "CALL SFB 1, DB 1 (CD := E 0.0, LOAD := E 0.1, PV := 1, Q := M 0.0, CV := MW 2);");
  plc.start();
  plc.write("E 0.1", 1);
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("MW 2"), 1u);
  EXPECT_EQ(plc.read("M 0.0"), 0u);
  plc.write("E 0.1", 0);
  plc.write("E 0.0", 1);
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("MW 2"), 0u);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
}

// S7-SFB-03
TEST(IecCounter, UpDown) {
  Plc plc = plcWith(
      2,
      "CALL SFB 2, DB 1 (CU := E 0.0, CD := E 0.1, R := E 0.2, LOAD := E 0.3, PV := 5, QU := M 0.0,"
      "QD := M 0.1, CV := MW 2);");
  plc.start();
  plc.write("E 0.0", 1);
  plc.write("E 0.1", 1);
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("MW 2"), 0u);  // both edges at once
  EXPECT_EQ(plc.read("M 0.1"), 1u);
  plc.write("E 0.3", 1);
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("MW 2"), 5u);
  EXPECT_EQ(plc.read("M 0.0"), 1u);
  plc.write("E 0.2", 1);  // R before LOAD
  plc->advanceCycles(2);
  EXPECT_EQ(plc.read("MW 2"), 0u);
}

// S7-SFB-07, S7-PAR-10: instances inside an FB.
TEST(IecTimer, AsMultipleInstances) {
  Plc plc(
      "FUNCTION_BLOCK FB 10\nVAR\n t1 : SFB 4;\n t2 : SFB 4;\nEND_VAR\nBEGIN\n"
      "CALL #t1 (IN := E 0.0, PT := T#100MS, Q := M 0.0); CALL #t2 (IN := E 0.0, PT := T#200MS, Q "
      ":= M 0.1);\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 10 FB 10\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\nCALL FB "
      "10, DB 10;\nEND_ORGANIZATION_BLOCK\n");
  plc.start();
  plc.write("E 0.0", 1);
  runFor(plc, 150);
  EXPECT_EQ(plc.read("MB 0"), 1u);
  runFor(plc, 100);
  EXPECT_EQ(plc.read("MB 0"), 3u);
}

// S7-SFB-04 to S7-SFB-07: the system time begins anew after 2^31 ms (24 d 20 h 31 min 23.648 s). In
// STOP that time passes at once.
TEST(IecTimer, AcrossTheEndOfTheSystemTime) {
  constexpr std::int64_t kWrap = std::int64_t{1} << 31;
  struct Kind {
    int sfb;
    bool before, after;  // Q while the time runs, and behind it
  };
  for (const Kind& row : {Kind{3, true, false}, Kind{4, false, true}, Kind{5, true, false}}) {
    Plc plc = plcWith(row.sfb, "CALL SFB " + std::to_string(row.sfb) +
                                   ", DB 1 (IN := E 0.0, PT := T#1S, Q := M 0.0, ET := MD 4);");
    plc.start();
    plc->stop();
    plc->advanceTo(Instant{(kWrap - 500) * 1'000'000});
    plc->warmRestart();
    runFor(plc, 10);
    plc.write("E 0.0", 1);
    runFor(plc, 10);
    if (row.sfb == 5) plc.write("E 0.0", 0);
    runFor(plc, 900);
    EXPECT_GT(plc->now().ns, kWrap * 1'000'000);
    EXPECT_EQ(plc.read("M 0.0") != 0, row.before) << row.sfb;
    EXPECT_NEAR(plc.read("MD 4"), 900, 15) << row.sfb;
    runFor(plc, 150);
    EXPECT_EQ(plc.read("M 0.0") != 0, row.after) << row.sfb;
    EXPECT_EQ(plc.read("MD 4"), 1000u) << row.sfb;
  }
}

}  // namespace
}  // namespace merker::station::test
