#include "catalogue/measuring_range.h"

#include <gtest/gtest.h>

namespace merker {
namespace {

const MeasuringRange& range(std::string_view name) { return *findMeasuringRange(name); }
int shown(std::string_view name, double amount, unsigned bits = 15, bool check = false) {
  return toShown(range(name), amount, bits, check);
}

struct Case {
  std::string_view range;
  double amount;
  int shown;
};

// S7-CPU-19; tables of the module data manual
TEST(MeasuringRange, analogValues) {
  const Case cases[] = {{"±10V", 10, 27648},
                        {"±10V", 5, 13824},
                        {"±10V", -10, -27648},
                        {"±10V", 0, 0},
                        {"±10V", 11.7589, 32511},
                        {"±10V", 11.76, 32767},
                        {"±10V", -11.7593, -32512},
                        {"±10V", -11.76, -32768},
                        {"0..10V", 10, 27648},
                        {"0..10V", -1.7593, -4864},
                        {"0..10V", -1.76, -32768},
                        {"0..20mA", 20, 27648},
                        {"0..20mA", 23.5176, 32511},
                        {"0..20mA", 23.53, 32767},
                        {"4..20mA", 4, 0},
                        {"4..20mA", 20, 27648},
                        {"4..20mA", 12, 13824},
                        {"4..20mA", 1.1852, -4864},
                        {"4..20mA", 1.18, -32768},
                        {"4..20mA", 22.9, 32767},
                        {"1..5V", 3, 13824},
                        {"±80mV", 0.08, 27648},
                        {"±2.5V", -2.5, -27648},
                        {"150Ohm", 75, 13824},
                        {"600 Ω", 600, 27648},
                        {"Pt100", 850, 8500},
                        {"Pt100", -200, -2000},
                        {"Pt100", 23.5, 235},
                        {"Pt100", 1000, 10000},
                        {"Pt100", 1000.2, 32767},
                        {"Pt100", -243, -2430},
                        {"Pt100", -244, -32768},
                        {"Pt100 climatic", 21.5, 2150},
                        {"Ni100", 250, 2500},
                        {"Type K", 1372, 13720}};
  for (const Case& c : cases) EXPECT_EQ(shown(c.range, c.amount), c.shown) << c.range << c.amount;
}

// S7-CPU-19: 12 bits leave low bits 0
TEST(MeasuringRange, resolution) {
  EXPECT_EQ(shown("±10V", 10, 11), 27648);
  EXPECT_EQ(shown("±10V", 3.333, 11) % 16, 0);
  EXPECT_EQ(shown("0..10V", 3.333, 12) % 8, 0);
  EXPECT_NE(shown("±10V", 3.333, 15) % 16, 0);
  EXPECT_EQ(shown("±10V", 12, 11), 32767);
  EXPECT_EQ(shown("Pt100", 23.5, 11), 235);  // a temperature is shown in full
}

TEST(MeasuringRange, wireBreakCheck) {
  EXPECT_EQ(shown("4..20mA", 3.5, 15, true), 32767);
  EXPECT_EQ(shown("4..20mA", 3.7, 15, true), shown("4..20mA", 3.7));
  EXPECT_LT(shown("4..20mA", 3.5), 0);
}

TEST(MeasuringRange, outputs) {
  EXPECT_DOUBLE_EQ(toAmount(range("±10V"), 27648), 10);
  EXPECT_DOUBLE_EQ(toAmount(range("±10V"), -13824), -5);
  EXPECT_DOUBLE_EQ(toAmount(range("4..20mA"), 13824), 12);
  EXPECT_DOUBLE_EQ(toAmount(range("4..20mA"), -6912), 0);
  EXPECT_DOUBLE_EQ(toAmount(range("0..10V"), -100), 0);
  EXPECT_DOUBLE_EQ(toAmount(range("±10V"), 32512), 0);  // overflow: no voltage
}

TEST(MeasuringRange, names) {
  EXPECT_EQ(&range("+-10V"), &range("±10V"));
  EXPECT_EQ(&range("+/- 10 v"), &range("±10V"));
  EXPECT_EQ(&range("4 .. 20 mA"), &range("4..20mA"));
  EXPECT_EQ(findMeasuringRange("0..5V"), nullptr);
}

}  // namespace
}  // namespace merker
