// The bodies of the measured loops, and how many calls are measured together.
#pragma once

#include <benchmark/benchmark.h>

namespace merker::bench {

// What is compared with each other is measured several times, in turns; the middle counts. A
// virtual machine is not alone on its host.
inline void severalTimes(benchmark::internal::Benchmark* one) {
  one->Repetitions(15)->MinTime(0.05);
}

constexpr const char* kMixed =
    "      L     MW 12\n      L     MW 14\n      +I\n      L     2\n      *I\n      T     MW 14\n"
    "      L     MD 20\n      L     L#5\n      +D\n      T     MD 20\n"
    "      U     E 0.1\n      U     M 3.2\n      =     A 4.0\n"
    "      L     MW 14\n      L     100\n      >I\n      SPB   far\n"
    "      L     MW 12\n      +     1\n      T     MW 12\nfar:  NOP 0\n";
constexpr const char* kReals =
    "      L     MD 20\n      L     1.5\n      *R\n      L     2.5\n      -R\n"
    "      L     3.0\n      /R\n      L     MD 24\n      +R\n      T     MD 28\n";
constexpr const char* kIndirect =
    "      LAR1  P#M 10.0\n      L     W [AR1,P#0.0]\n      L     MW [MD 60]\n      +I\n"
    "      T     MW [AR1,P#8.0]\n      U     M [AR1,P#1.3]\n      =     A [AR1,P#0.1]\n"
    "      +AR1  P#2.0\n";
constexpr const char* kTimers =
    "      U     E 0.1\n      L     S5T#2S\n      SE    T 1\n      U     T 1\n      =     A 4.0\n"
    "      L     T 1\n      T     MW 30\n      U     E 0.2\n      ZV    Z 1\n      U     Z 1\n"
    "      =     A 4.1\n";

constexpr int kCalls = 500;

}  // namespace merker::bench
