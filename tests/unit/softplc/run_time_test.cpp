// The virtual clock is the sum of the times that chapter 9.5 prints. S5-OPC-04, S5-BLK-20
#include <fstream>
#include <sstream>

#include "listing_bench.h"
#include "mc5/encoding.h"

namespace merker::sinumerik {
namespace {

// Statements of a function block with their printed times in nanoseconds, and how often they run.
// Of a range the longer one counts, since all of them have something to do.
struct Printed {
  const char* statement;
  std::int64_t cop, acop;
  int runs = 1;
};
constexpr Printed kStatements[] = {{": A DB 10", 15'400, 1'000},
                                   {": L KH 1234", 8'800, 500},
                                   {": L KG +1000000+01", 10'500, 750},
                                   {": T MD 100", 9'500, 1'000},
                                   {": L DW 0", 8'300, 500},
                                   {": T DL 1", 8'600, 500},
                                   {": L EB 4", 7'300, 500},
                                   {": U M 100.0", 750, 750},
                                   {": U(", 300, 250},
                                   {": O E 1.0", 750, 750},
                                   {": )", 300, 250},
                                   {": = D 1.3", 30'200, 1'000},
                                   {": SU M 101.0", 21'500, 1'000},
                                   {": P D 1.3", 24'300, 750},
                                   {": TAK", 6'900, 250},
                                   {": ADD KF +5", 8'300, 250},
                                   {": +F", 9'700, 250},
                                   {": DEF", 20'000, 20'000},
                                   {": SLW 3", 7'100, 1'500},
                                   {": L KB 3", 4'400, 250},
                                   {"M1 : T MB 110", 6'400, 500, 3},
                                   {": L MB 110", 5'800, 500, 3},
                                   {": D 1", 3'400, 250, 3},
                                   {": L KB 0", 4'400, 250, 3},
                                   {": ><F", 14'000, 250, 3},
                                   {": TAK", 6'900, 250, 3},
                                   {": BLD 7", 3'000, 250, 3}};
// SPB =M1 is taken twice.
constexpr std::int64_t kTaken[] = {6'100, 320}, kNotTaken[] = {300, 320};
// SPA FB, the jump over its empty list, two times BE
constexpr std::int64_t kAround[] = {35'800 + 6'100 + 2 * 22'800, 2'000 + 320 + 2 * 22'800};

std::string listing() {
  std::string text = "OB 1\n: SPA FB 1\nNAME : ZEIT\n: BE\nFB 1\nNAME : ZEIT\n";
  for (const Printed& row : kStatements) text += std::string(row.statement) + "\n";
  return text + ": SPB =M1\n: BE\nDB 10\nKH 0000\nKH 0000\n";
}

std::int64_t printed(bool acop) {
  std::int64_t sum = kAround[acop] + 2 * kTaken[acop] + kNotTaken[acop];
  for (const Printed& row : kStatements) sum += row.runs * (acop ? row.acop : row.cop);
  return sum;
}

TEST(RunTime, TheClockIsTheSumOfThePrintedTimes) {
  for (const bool acop : {false, true}) {
    ListingBench b(listing());
    b.options.variant = acop ? mc5::Variant::Acop : mc5::Variant::Cop;
    std::int64_t atEnd = 0;  // of the first cycle; it begins at 0
    b.plc().onCycle([&](Plc& plc) { atEnd = atEnd == 0 ? plc.now().ns : atEnd; });
    b.run(10);
    EXPECT_EQ(b.plc().operatingSystem().runTimes().cycle.cyclic.ns, printed(acop)) << acop;
    EXPECT_EQ(atEnd, printed(acop)) << acop;
  }
}

// The same for whole programs: what each instruction takes, times how often it ran.
struct Sum {
  std::int64_t shortest = 0, longest = 0;
};

Sum sumOf(const Plc& plc, mc5::Variant variant) {
  Sum sum;
  for (const auto& [id, counts] : plc.executed())
    for (const auto& [offset, count] : counts) {
      const auto& words = plc.program().at(id).words;
      const auto decoded = mc5::decode(std::span(words).subspan(offset));
      if (!decoded) continue;
      const mc5::Times times = mc5::times(*decoded->encoding, variant);
      sum.shortest += static_cast<std::int64_t>(count) * times.shortest.ns;
      sum.longest += static_cast<std::int64_t>(count) * times.longest.ns;
    }
  return sum;
}

std::string contents(const char* name) {
  std::ostringstream text;
  text << std::ifstream(std::string(MERKER_SOURCE_DIR "/tests/conformance/step5/") + name).rdbuf();
  return text.str();
}

TEST(RunTime, ProgramsStayBetweenTheirPrintedTimes) {
  for (const char* name : {"bit_chains.s5", "compare.s5", "jumps.s5", "load.s5", "store.s5"}) {
    ListingBench b(contents(name));
    b.set(2003, 1, false);
    b.options.coverage = true;
    b.run(10'000);
    const Sum sum = sumOf(b.plc(), b.options.variant);
    const std::int64_t taken = b.plc().operatingSystem().runTimes().cycle.cyclic.ns;
    EXPECT_GT(sum.shortest, 0) << name;
    EXPECT_GE(taken, sum.shortest) << name;
    EXPECT_LE(taken, sum.longest) << name;
  }
}

}  // namespace
}  // namespace merker::sinumerik
