// SFB 0 CTU, 1 CTD, 2 CTUD (S7-SFB-01 … -03). The last static values remember the inputs.
#include "system/call.h"

namespace merker::system {
namespace {

// Rising edge of parameter `input` against the memory in parameter `memory`.
template <typename A>
bool rising(A& a, NameIn<A> input, NameIn<A> memory) {
  const bool now = a.flag(input), before = a.flag(memory);
  a.set(memory, now);
  return now && !before;
}

template <typename A>
void store(A& a, std::int32_t count) {
  a.set("CV", static_cast<std::uint16_t>(count));
}

}  // namespace

void countUp(Sfb<0>& a) {
  std::int32_t count = a.integer("CV");
  if (rising(a, "CU", "CUO") && count < INT16_MAX) ++count;
  if (a.flag("R")) count = 0;
  store(a, count);
  a.set("Q", count >= a.integer("PV"));
}

void countDown(Sfb<1>& a) {
  std::int32_t count = a.integer("CV");
  if (rising(a, "CD", "CDO") && count > INT16_MIN) --count;
  if (a.flag("LOAD")) count = a.integer("PV");
  store(a, count);
  a.set("Q", count <= 0);
}

// Both edges at once change nothing; R goes before LOAD.
void countUpDown(Sfb<2>& a) {
  std::int32_t count = a.integer("CV");
  const bool rises = rising(a, "CU", "CUO"), falls = rising(a, "CD", "CDO");
  if (rises && !falls && count < INT16_MAX) ++count;
  if (falls && !rises && count > INT16_MIN) --count;
  if (a.flag("R"))
    count = 0;
  else if (a.flag("LOAD"))
    count = a.integer("PV");
  store(a, count);
  a.set("QU", count >= a.integer("PV"));
  a.set("QD", count <= 0);
}

}  // namespace merker::system
