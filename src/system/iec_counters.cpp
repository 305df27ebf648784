// SFB 0 CTU, 1 CTD, 2 CTUD (S7-SFB-01 … -03). The last static values remember the inputs.
#include "system/arguments.h"

namespace merker::system {
namespace {

// Rising edge of parameter `input` against the memory in parameter `memory`.
bool rising(Arguments& a, std::size_t input, std::size_t memory) {
  const bool now = a.flag(input), before = a.flag(memory);
  a.set(memory, now);
  return now && !before;
}

void store(Arguments& a, std::size_t i, std::int32_t count) {
  a.set(i, static_cast<std::uint16_t>(count));
}

}  // namespace

void countUp(Arguments& a) {
  enum { CU, R, PV, Q, CV, CUO };
  std::int32_t count = a.integer(CV);
  if (rising(a, CU, CUO) && count < INT16_MAX) ++count;
  if (a.flag(R)) count = 0;
  store(a, CV, count);
  a.set(Q, count >= a.integer(PV));
}

void countDown(Arguments& a) {
  enum { CD, LOAD, PV, Q, CV, CDO };
  std::int32_t count = a.integer(CV);
  if (rising(a, CD, CDO) && count > INT16_MIN) --count;
  if (a.flag(LOAD)) count = a.integer(PV);
  store(a, CV, count);
  a.set(Q, count <= 0);
}

// Both edges at once change nothing; R goes before LOAD.
void countUpDown(Arguments& a) {
  enum { CU, CD, R, LOAD, PV, QU, QD, CV, CUO, CDO };
  std::int32_t count = a.integer(CV);
  const bool rises = rising(a, CU, CUO), falls = rising(a, CD, CDO);
  if (rises && !falls && count < INT16_MAX) ++count;
  if (falls && !rises && count > INT16_MIN) --count;
  if (a.flag(R))
    count = 0;
  else if (a.flag(LOAD))
    count = a.integer(PV);
  store(a, CV, count);
  a.set(QU, count >= a.integer(PV));
  a.set(QD, count <= 0);
}

}  // namespace merker::system
