// The data types of FB 61 and FB 62, row by row against the manual's table, all through the PLC.
#include "nc/data_type.h"

#include "rig.h"

namespace merker::nc {
namespace {

constexpr const char* kB = "B0 B1 B2 B3 B4 B5 B6 B7 B8 B9";
constexpr const char* kF = "F0 F1 F2 F3 F4 F5 F6 F7 F8 F9";
const std::string kAll = std::string(kB) + " " + kF;
const std::string kTool = kAll + " BG BI";
const std::string kParameter = kAll + " FA FB FC FD FE FF BG BI";
const std::string kActual = std::string(kB) + " BG F0";

struct Expected {
  const char* name;
  Where where;  // permitted
  std::string read, write;
  int most;
};
// S5-FM-T2
const std::vector<Expected> kExpected = {
    {"MDN", {4900, 0, 0}, "B0 F0", "B0 F0", 80},
    {"MDNBY", {5000, 0, 0}, "BI", "BI", 80},
    {"SEN", {0, 0, 0}, "B0 F0", "B0 F0", 80},
    {"SENBY", {9900, 0, 0}, "BI", "BI", 30},
    {"TOS", {0, 99, 0}, kTool, kTool, 16},
    {"TOA", {99, 15, 0}, "", kTool, 1},
    {"ZOA", {4, 5, 1}, kAll, kAll + " BG", 1},
    {"ZOPR", {2, 5, 0}, kAll, kAll + " BG", 1},
    {"ZOFA", {4, 5, 1}, "", kAll + " BG", 1},
    {"ZOE", {5, 0, 0}, kAll, kAll + " BG", 1},
    {"ZOPS", {5, 0, 0}, kAll + " BG", std::string(kB) + " BG F4", 1},
    {"ZOS", {5, 0, 0}, kActual, "", 1},
    {"ACPW", {5, 0, 0}, kActual, "", 1},
    {"ACPM", {5, 0, 0}, kActual, "", 1},
    {"EXBF", {2, 1, 0}, "B4 F4", "B4 F4", 1},
    {"PP", {2, 3, 0}, "B0 F0", "", 1},
    {"INITMP", {2, 0, 0}, "", "B0 F0", 1},
    {"INITSP", {2, 0, 0}, "", "B0 F0", 1},
    {"RPNC", {2, 400, 0}, kParameter, kParameter, 80},
    {"RPNC", {0, 900, 0}, kParameter, kParameter, 80},
    {"NCAL", {0, 0, 0}, "B0 F0", "", 127},
};

std::string outcome(const Expected& row, unsigned macro, const std::string& format, int count) {
  Call call;
  call.macro = macro;
  call.type = row.name;
  call.where = row.where;
  call.format = format;
  call.count = count;
  call.place = "255,0";
  Rig rig;
  EXPECT_TRUE(rig.start(dataBlock(255, 254) + cyclic(call.text())));
  const bool program = std::string(row.name).starts_with("INIT");  // there is no program 0
  rig.word(255, format[0] == 'B' ? 2 : 1) = program ? 1 : 0;
  rig.machine().flags[100] = 1;
  rig.cycles(3);
  if (rig.stopped()) return rig.stop();
  return (rig.interfaceByte(1) & 0x80) != 0 ? "FEHLER" : "";
}

// Interface byte 1 in the high byte of AKKU 2.
std::string stopped(unsigned macro, int error) {
  return std::to_string(macro) + "/" + std::to_string(256 + error);
}

bool contains(const std::string& list, const std::string& format) {
  return list.find(format) != std::string::npos;
}

// S5-FM-36, S5-FM-42: each data type with each format in both directions.
TEST(DataTypes, Formats) {
  std::vector<std::string> formats;
  for (unsigned i = 0; i < 28; ++i) formats.emplace_back(name(static_cast<Format>(i)));
  formats.emplace_back("BA");
  for (const Expected& row : kExpected)
    for (const unsigned macro : {61u, 62u})
      for (const std::string& format : formats) {
        const std::string& permitted = macro == 61 ? row.read : row.write;
        const bool may = !permitted.empty() && contains(permitted, format);
        EXPECT_EQ(outcome(row, macro, format, 1),
                  may ? "" : stopped(macro, permitted.empty() ? 5 : 6))
            << row.name << ' ' << macro << ' ' << format;
      }
}

// S5-FM-28, S5-FM-34, S5-FM-42: as many values as the table says; errors 0 and 4.
TEST(DataTypes, LargestNumber) {
  for (const Expected& row : kExpected) {
    const unsigned macro = row.read.empty() ? 62 : 61;
    const std::string& formats = macro == 61 ? row.read : row.write;
    const std::string format = contains(formats, "BI") ? "BI" : formats.substr(0, 2);
    const int most = row.most > 80 ? 80 : row.most;  // more do not fit a data block
    EXPECT_EQ(outcome(row, macro, format, most), "") << row.name;
    if (row.most < 127) {
      EXPECT_EQ(outcome(row, macro, format, row.most + 1), stopped(macro, row.most == 1 ? 0 : 4))
          << row.name;
    }
    EXPECT_EQ(outcome(row, macro, format, -1), stopped(macro, 4)) << row.name;
    EXPECT_EQ(outcome(row, macro, format, 129), stopped(macro, 4)) << row.name;
  }
  EXPECT_EQ(outcome(kExpected.back(), 61, "F0", 127), "");
}

// S5-FM-31, S5-FM-34, S5-FM-35: error 3; the digit 0 is no letter O (OP-14).
TEST(DataTypes, UnknownType) {
  for (const char* const name : {"XX", "T0S", "MD", "MDNB", "ACPWX"})
    EXPECT_EQ(outcome({name, {1, 1, 0}, "", "", 1}, 61, "F0", 1), "61/259") << name;
}

// S5-FM-34: error 7, for ZOA and ZOFA only.
TEST(DataTypes, CoarseOrFine) {
  EXPECT_EQ(outcome({"ZOA", {1, 1, 2}, "", "", 1}, 61, "F0", 1), "61/263");
  EXPECT_EQ(outcome({"ZOFA", {1, 1, -1}, "", "", 1}, 62, "F0", 1), "62/263");
  EXPECT_EQ(outcome({"TOS", {0, 1, 16}, "", "", 1}, 61, "F0", 1), "FEHLER");
}

// S5-FM-42: limits of WER1 … WER3; beyond them the NC refuses.
TEST(DataTypes, Limits) {
  const struct {
    const char* name;
    Where low, high;
  } rows[] = {{"MDN", {0, 0, 0}, {4999, 0, 0}}, {"MDNBY", {5000, 0, 0}, {9999, 0, 0}},
              {"SEN", {0, 0, 0}, {4999, 0, 0}}, {"SENBY", {5000, 0, 0}, {9999, 0, 0}},
              {"TOS", {0, 1, 0}, {0, 99, 15}},  {"ZOA", {1, 1, 0}, {4, 5, 1}},
              {"ZOPR", {1, 1, 0}, {2, 5, 0}},   {"ZOE", {1, 0, 0}, {5, 0, 0}},
              {"ZOPS", {1, 0, 0}, {5, 0, 0}},   {"ZOS", {1, 0, 0}, {5, 0, 0}},
              {"ACPW", {1, 0, 0}, {5, 0, 0}},   {"ACPM", {1, 0, 0}, {5, 0, 0}},
              {"EXBF", {1, 0, 0}, {2, 1, 0}},   {"PP", {1, 0, 0}, {2, 3, 0}},
              {"RPNC", {1, 0, 0}, {2, 499, 0}}, {"RPNC", {0, 900, 0}, {0, 999, 0}},
              {"TOA", {1, 0, 0}, {99, 15, 0}},  {"ZOFA", {1, 1, 0}, {4, 5, 1}},
              {"INITMP", {1, 0, 0}, {2, 0, 0}}, {"INITSP", {1, 0, 0}, {2, 0, 0}}};
  for (const auto& row : rows) {
    const DataType* const type = findDataType(row.name, row.low, Model::Grinding);
    ASSERT_NE(type, nullptr);
    EXPECT_TRUE(withinLimits(*type, row.low)) << row.name;
    EXPECT_TRUE(withinLimits(*type, row.high)) << row.name;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!type->limits[i].used()) continue;
      Where below = row.low, above = row.high;
      --below[i];
      ++above[i];
      EXPECT_FALSE(withinLimits(*type, below)) << row.name << i;
      EXPECT_FALSE(withinLimits(*type, above)) << row.name << i;
    }
  }
}

// S5-FM-42: parameters 0 … 9 of a tool offset on turning and milling controls, 0 … 15 on G.
TEST(DataTypes, ToolOffsetsOfTheModel) {
  for (const Model model : {Model::Turning, Model::Milling, Model::Nibbling, Model::Grinding}) {
    const bool grinding = model == Model::Grinding;
    const DataType* const type = findDataType("TOS", {0, 1, 0}, model);
    ASSERT_NE(type, nullptr);
    EXPECT_EQ(type->most, grinding ? 16u : 10u);
    EXPECT_EQ(withinLimits(*type, {0, 1, 10}), grinding);
    EXPECT_EQ(withinLimits(*findDataType("TOA", {1, 1, 0}, model), {1, 10, 0}), grinding);
  }
}

}  // namespace
}  // namespace merker::nc
