// What the measurements must reach on a present-day PC.
#pragma once

#include <span>
#include <string_view>

namespace merker::bench {

// What the machine can do at all (limit.cpp), and how many bit operations a second that is on the
// machine for which absolute values are required: two virtual cores of an AMD EPYC at 2.6 GHz.
constexpr std::string_view kLimit = "BitLogicLimit";
constexpr double kReferenceSpeed = 4.13e9;

enum class Unit {
  Seconds,   // per iteration
  Rate,      // items a second
  RealTime,  // virtual nanoseconds a second, shown as times real time
  Bytes,     // counter "bytes"
};
enum class Limit { None, AtMost, AtLeast };

// One measurement.
struct Single {
  std::string_view benchmark, label;
  Unit unit;
  Limit limit;
  double value;
};
// The same with both engines: "Reals" and "RealsCompiled". Compiled must reach `compiled` and the
// share of the `reference`, and `times` what the interpreter reached.
struct Pair {
  std::string_view benchmark, label;
  Unit unit;
  double interpreted;  // at least
  double compiled;     // at least
  double share = 0;    // of what a C or C++ compiler makes of the same program
  double times = 10;
  std::string_view reference = kLimit;
};

std::span<const Single> singles();
std::span<const Pair> pairs();
const Single* findSingle(std::string_view benchmark);
// Also by the name of the compiled one.
const Pair* findPair(std::string_view benchmark);
inline bool isCompiled(std::string_view benchmark) { return benchmark.ends_with("Compiled"); }

}  // namespace merker::bench
