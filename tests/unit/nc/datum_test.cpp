// The data of the NC by name (docs/formats/nc.md).
#include "nc/datum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace merker::nc {
namespace {

Datum named(const std::string& text) {
  const auto datum = parseDatum(text);
  EXPECT_TRUE(datum) << text;
  return datum.value_or(Datum{});
}

// The page has a row for each name, and the table a name for each row of the page.
TEST(Datum, ThePageHasThemAll) {
  std::ifstream file(MERKER_SOURCE_DIR "/docs/formats/nc.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const DatumRow& row : datumRows())
    for (const std::string_view name : {row.name, row.alias})
      if (!name.empty()) {
        EXPECT_NE(page.str().find("`" + std::string(name) + "`"), std::string::npos) << name;
      }
}

TEST(Datum, EachComesBackFromItsBits) {
  for (unsigned row = 0; row < datumRows().size(); ++row) {
    Where low{}, high{};
    for (unsigned i = 0; i < indexCount(datumRows()[row]); ++i) {
      low.at(i) = datumRows()[row].limits.at(i).low;
      high.at(i) = datumRows()[row].limits.at(i).high;
    }
    for (const Where& where : {low, high}) {
      const std::uint32_t packed = pack({row, where});
      EXPECT_NE(packed, 0u);
      EXPECT_EQ(unpack(packed).row, row);
      EXPECT_EQ(unpack(packed).where, where);
    }
  }
}

// Each value that can be set is read back, at both ends of its numbers, and is no other's.
TEST(Datum, EachIsItsOwn) {
  Control control;
  std::vector<std::pair<Datum, std::string>> all;
  for (unsigned row = 0; row < datumRows().size(); ++row) {
    const DatumRow& r = datumRows()[row];
    if (r.put == nullptr || r.name == "input_system" || r.name == "alarm") continue;
    for (const bool end : {false, true}) {
      Datum datum{row, {}};
      for (unsigned i = 0; i < indexCount(r); ++i)
        datum.where.at(i) = end ? r.limits.at(i).high : r.limits.at(i).low;
      const std::int32_t value = r.content == Content::Whole
                                     ? std::min<std::int32_t>(r.highest, 2)
                                     : static_cast<std::int32_t>(100 + all.size());
      ASSERT_TRUE(writeDatum(control, datum, {value, 0})) << r.name;
      all.emplace_back(datum, readDatum(control, datum));
      EXPECT_EQ(
          parseDecimal(all.back().second)->digits / (r.content == Content::Position ? 1000 : 1),
          value)
          << r.name;
    }
  }
  for (const auto& [datum, text] : all)
    EXPECT_EQ(readDatum(control, datum), text) << rowOf(datum).name;
}

TEST(Datum, Names) {
  EXPECT_EQ(named("nc.R 50").where, (Where{1, 50, 0}));
  EXPECT_EQ(named("NC.r50").where, (Where{1, 50, 0}));
  EXPECT_EQ(named("nc.R 2.50").where, (Where{2, 50, 0}));
  EXPECT_EQ(named("nc.R 900").where, (Where{0, 900, 0}));
  EXPECT_EQ(named("nc.R 0.900").row, named("nc.R 900").row);
  EXPECT_EQ(named("nc.Parameters 1.0").row, named("nc.R 1.0").row);
  EXPECT_EQ(named("nc.feed_G95 3").where, (Where{3, 0, 0}));
  EXPECT_EQ(named("nc.settable_offset 4.5").where, (Where{4, 5, 0}));
  EXPECT_EQ(named("nc.settable_offset 4.5.1").where, (Where{4, 5, 1}));
  EXPECT_EQ(named("nc.MD 4999").row + 1, named("nc.MD 5000").row);
  for (const char* wrong : {"nc.",
                            "nc.R",
                            "nc.R 500",
                            "nc.R 3.1",
                            "nc.R 0.50",
                            "nc.R 1.900",
                            "nc.R 1.2.3.4",
                            "nc.R -1",
                            "nc.R 1.",
                            "nc.R .1",
                            "nc.R 1..2",
                            "nc.R 99999999999",
                            "nc.machining_stop 1",
                            "R 50",
                            "nc.tool 5",
                            "nc.feed 0",
                            "nc.probe",
                            "nc.settable_offset 1",
                            "ncR 50",
                            "nc.R 1 2"})
    EXPECT_FALSE(parseDatum(wrong)) << wrong;
}

TEST(Datum, Decimals) {
  struct Row {
    std::string_view text;
    Number number;
  };
  for (const Row& row : {Row{"12.345", {12345, 3}}, Row{"-0.5", {-5, 1}}, Row{"0", {0, 0}},
                         Row{"1.00", {100, 2}}, Row{"-12", {-12, 0}}, Row{"0.00000001", {1, 8}}}) {
    EXPECT_EQ(parseDecimal(row.text), row.number);
    EXPECT_EQ(formatDecimal(row.number), row.text);
  }
  EXPECT_EQ(parseDecimal("+7"), (Number{7, 0}));
  for (const char* wrong : {"", "-", ".", "1.2.3", "1e5", " 1", "1 ", "9999999999", "0.123456789",
                            "--1", "+-1", "5.", ".5"})
    EXPECT_FALSE(parseDecimal(wrong)) << wrong;
}

TEST(Datum, WhatIsRefused) {
  Control control;
  EXPECT_FALSE(writeDatum(control, named("nc.R 1"), {123'456'789, 0}));
  EXPECT_FALSE(writeDatum(control, named("nc.feed 1"), {-1, 0}));
  EXPECT_FALSE(writeDatum(control, named("nc.position 1"), {1, 4}));
  EXPECT_TRUE(writeDatum(control, named("nc.position 1"), {10, 4}));
  EXPECT_EQ(control.axes[0].position, 1);
  EXPECT_FALSE(writeDatum(control, named("nc.position 1"), {100'000, 0}));  // nine digits
  EXPECT_FALSE(writeDatum(control, named("nc.spindle_speed 1"), {15, 1}));
  EXPECT_TRUE(writeDatum(control, named("nc.spindle_speed 1"), {150, 1}));
  EXPECT_EQ(control.spindleSpeed[0], 15);
  EXPECT_FALSE(writeDatum(control, named("nc.program_pointer 1.0.1"), {3, 0}));
  EXPECT_FALSE(writeDatum(control, named("nc.sum_offset 1"), {0, 0}));
  control.inputSystem = InputSystem::Inch;
  EXPECT_TRUE(writeDatum(control, named("nc.position 1"), {1, 4}));
  EXPECT_EQ(readDatum(control, named("nc.position 1")), "0.0001");
}

TEST(Datum, WhatThereIs) {
  EXPECT_EQ(knownData("nc.tool 100.1"), "nc.tool 1..99.0..15 (D.P)");
  const std::string all = knownData("nc.tol 1");
  EXPECT_TRUE(all.starts_with("nc.R, nc.tool, nc.machine_data, nc.setting_data, nc.position"));
}

}  // namespace
}  // namespace merker::nc
