// SFB 3 TP, 4 TON, 5 TOF (S7-SFB-04 … -07): milliseconds of the system time, looked at when called.
#include <algorithm>

#include "system/call.h"

namespace merker::system {
namespace {

enum : std::uint32_t { Idle, Running, Done };

std::uint32_t systemTime(Arguments& a) {
  constexpr std::int64_t kTick = 1'000'000;  // ns
  cpu::Machine& m = a.machine();
  m.outlook.until(Instant{(m.clock.ns / kTick + 1) * kTick},
                  {.at = cpu::Look::At::SystemBlock,
                   .block = m.top->code->source->id,
                   .offset = m.position,
                   .called = {BlockKind::SFB, a.functionNumber()}});
  return static_cast<std::uint32_t>(a.machine().clock.ns / 1'000'000 & 0x7FFFFFFF);
}

template <typename A>
void start(A& a) {
  a.set("STIME", systemTime(a));
  a.set("STATE", Running);
}

// Time since the start, no longer than PT.
template <typename A>
std::int32_t elapsed(A& a) {
  const std::uint32_t since = (systemTime(a) - a.value("STIME")) & 0x7FFFFFFF;
  const std::int32_t preset = std::max(a.longInteger("PT"), 0);
  return std::min(static_cast<std::int32_t>(since), preset);
}

template <typename A>
void show(A& a, bool q, std::int32_t time) {
  a.set("Q", q);
  a.set("ET", static_cast<std::uint32_t>(time));
}

template <typename A>
bool expired(A& a, std::int32_t time) {
  return time >= std::max(a.longInteger("PT"), 0);
}

}  // namespace

// Edges during the pulse have no effect.
void timePulse(Sfb<3>& a) {
  const bool in = a.flag("IN");
  if (a.value("STATE") == Idle) {
    if (!in) return show(a, false, 0);
    start(a);
  }
  std::int32_t time = a.value("STATE") == Done ? a.longInteger("ET") : elapsed(a);
  const bool over = a.value("STATE") == Done || expired(a, time);
  if (over) {
    a.set("STATE", in ? Done : Idle);
    if (!in) time = 0;
  }
  show(a, !over, time);
}

void timeOnDelay(Sfb<4>& a) {
  if (!a.flag("IN")) {
    a.set("STATE", Idle);
    return show(a, false, 0);
  }
  if (a.value("STATE") == Idle) start(a);
  const std::int32_t time =
      a.value("STATE") == Done ? std::max(a.longInteger("PT"), 0) : elapsed(a);
  if (expired(a, time)) a.set("STATE", Done);
  show(a, expired(a, time), time);
}

void timeOffDelay(Sfb<5>& a) {
  if (a.flag("IN")) {
    a.set("STATE", Done);  // armed
    return show(a, true, 0);
  }
  if (a.value("STATE") == Idle) return;  // never on, or the time is over: Q and ET stay
  if (a.value("STATE") == Done) start(a);
  const std::int32_t time = elapsed(a);
  const bool over = expired(a, time);
  if (over) a.set("STATE", Idle);
  show(a, !over, time);
}

}  // namespace merker::system
