#include "requirements.h"

#include <algorithm>
#include <array>

namespace merker::bench {
namespace {

constexpr std::array kSingles{
    Single{"Compile100000Lines", "compile 100,000 lines of AWL", Unit::Seconds, Limit::AtMost, 2},
    Single{"Translate100000Lines", "100,000 lines to machine code", Unit::Seconds, Limit::AtMost,
           0.5},
    Single{"CodeOfABitInstruction", "machine code of a bit instruction", Unit::Bytes, Limit::AtMost,
           20},
    Single{"StartOfASmallProgram", "start, compile and run a small program", Unit::Seconds,
           Limit::AtMost, 0.050},
    Single{kLimit, "bit operations, written in C++", Unit::Rate, Limit::None, 0},
    Single{"CountedEncoder", "counts of a 60 kHz encoder, quadruple", Unit::Rate, Limit::AtLeast,
           24e6},
    Single{"CountedEncoders", "counts of four such encoders together", Unit::Rate, Limit::AtLeast,
           24e6},
    Single{"FourAxes", "four axes with encoders of 60 kHz", Unit::RealTime, Limit::AtLeast, 100},
    Single{"BusyComputerLink", "a 314C with a busy RK 512 line", Unit::RealTime, Limit::AtLeast,
           1000},
    Single{"MixedLoopInC", "mixed loop, written in C", Unit::Rate, Limit::None, 0},
    Single{"RealsInC", "REAL, written in C", Unit::Rate, Limit::None, 0},
    Single{"IndirectInC", "indirect addressing, written in C", Unit::Rate, Limit::None, 0},
    Single{"TimersInC", "timers and counters, written in C", Unit::Rate, Limit::None, 0},
    Single{"FcCallsInC", "calls of a function, written in C", Unit::Rate, Limit::None, 0},
    Single{"FbCallsInC", "calls with an instance, written in C", Unit::Rate, Limit::None, 0},
    Single{"Cycles", "cycles with process image", Unit::Rate, Limit::None, 0},
    Single{"ThousandCpus", "1,000 CPUs on two threads, each", Unit::RealTime, Limit::AtLeast, 100},
    Single{"ThousandPlants", "1,000 CPUs of one plant each, two threads, each", Unit::RealTime,
           Limit::AtLeast, 100},
    Single{"WeekOfATimer", "a week with one S5 timer a second", Unit::Seconds, Limit::AtMost, 10},
    Single{"ThousandComputerLinks", "1,000 CPUs with a busy RK 512 line on two threads, each",
           Unit::RealTime, Limit::AtLeast, 1},
    Single{"MemoryOfThousandCpus", "memory of 1,000 CPUs", Unit::Bytes, Limit::AtMost, 2e9},
};

constexpr std::array kPairs{
    Pair{"Instructions", "mixed instructions, straight on", Unit::Rate, 100e6, 0},
    Pair{"BitLogic", "10,000 bit instructions, straight on", Unit::Rate, 0, 0, 0.8},
    Pair{"MixedLoop", "mixed loop", Unit::Rate, 0, 0, 0.5, 10, "MixedLoopInC"},
    Pair{"Reals", "REAL", Unit::Rate, 0, 0, 0.5, 10, "RealsInC"},
    Pair{"Indirect", "indirect addressing", Unit::Rate, 0, 0, 0.5, 10, "IndirectInC"},
    Pair{"Timers", "timers and counters", Unit::Rate, 0, 0, 0.5, 10, "TimersInC"},
    Pair{"FcCalls", "calls of an FC with five parameters", Unit::Rate, 3e6, 50e6, 0.5, 10,
         "FcCallsInC"},
    Pair{"FbCalls", "calls of an FB with five parameters", Unit::Rate, 0, 50e6, 0.5, 10,
         "FbCallsInC"},
    Pair{"Step5", "STEP 5: 20 PB with data blocks", Unit::Rate, 0, 0},
    Pair{"BusyCpu", "a 314C, 1,000 instructions, each cycle", Unit::RealTime, 0, 2000, 0, 0},
    Pair{"IdleCpu", "an idle 314C, 1,000 instructions", Unit::RealTime, 0, 200e3, 0, 0},
    Pair{"SortingPlant", "the sorting plant with its scenario", Unit::RealTime, 0, 0, 0, 0},
    Pair{"TenMinutes", "ten minutes of the sorting plant", Unit::RealTime, 0, 20e3, 0, 0},
};

}  // namespace

std::span<const Single> singles() { return kSingles; }
std::span<const Pair> pairs() { return kPairs; }

const Single* findSingle(std::string_view benchmark) {
  const auto found =
      std::ranges::find_if(kSingles, [&](const Single& s) { return s.benchmark == benchmark; });
  return found == kSingles.end() ? nullptr : &*found;
}

const Pair* findPair(std::string_view benchmark) {
  constexpr std::string_view kEnding = "Compiled";
  if (isCompiled(benchmark)) benchmark.remove_suffix(kEnding.size());
  const auto found =
      std::ranges::find_if(kPairs, [&](const Pair& p) { return p.benchmark == benchmark; });
  return found == kPairs.end() ? nullptr : &*found;
}

}  // namespace merker::bench
