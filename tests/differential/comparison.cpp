#include "comparison.h"

#include <fmt/ranges.h>

#include <cstring>

namespace merker::differential {
namespace {

using cpu::Cpu;

void registers(Comparison& c, const cpu::Registers& a, const cpu::Registers& b) {
  for (std::size_t i = 0; i < a.accu.size(); ++i) c.hex("accu", i + 1, a.accu[i], b.accu[i]);
  c.hex("ar", 1, a.ar1, b.ar1);
  c.hex("ar", 2, a.ar2, b.ar2);
  c.hex("status word", 0, a.status.word(), b.status.word());
  const auto open = [&](const char* name, const cpu::OpenBlock& x, const cpu::OpenBlock& y) {
    c.value(name, x.number, y.number);
    c.value(name, x.length, y.length);
    c.value(name, x.writable, y.writable);
  };
  open("open db", a.db, b.db);
  open("open di", a.di, b.di);
}

void frames(Comparison& c, const cpu::Machine& a, const cpu::Machine& b) {
  c.value("frames", a.frames.size(), b.frames.size());
  for (std::size_t i = 1; i < std::min(a.frames.size(), b.frames.size()); ++i) {
    const cpu::Frame &x = a.frames[i], &y = b.frames[i];
    if (x.code->source->id != y.code->source->id)
      c.value("frame", i, toString(x.code->source->id), toString(y.code->source->id));
    c.value("frame resume", i, x.resume, y.resume);
    c.value("frame local", i, x.localLength, y.localLength);
    c.value("frame db", i, x.db.number, y.db.number);
    c.value("frame di", i, x.di.number, y.di.number);
    c.hex("frame ar2", i, x.ar2, y.ar2);
    c.value("frame mcr", i, x.mcrActive, y.mcrActive);
    c.value("frame mcr depth", i, x.mcrDepth, y.mcrDepth);
    c.value("frame brackets", i, x.bracketDepth, y.bracketDepth);
    c.value("frame parameters", i, x.parameterCount, y.parameterCount);
  }
}

void levels(Comparison& c, const cpu::Machine& a, const cpu::Machine& b) {
  c.value("levels", a.levels.size(), b.levels.size());
  for (std::size_t i = 0; i < std::min(a.levels.size(), b.levels.size()); ++i) {
    const cpu::Level &x = a.levels[i], &y = b.levels[i];
    c.value("level ob", i, x.ob, y.ob);
    c.value("level priority", i, x.priority, y.priority);
    c.value("level frames", i, x.frames, y.frames);
    c.value("level local stack", i, x.localStack, y.localStack);
    c.value("level mcr", i, x.mcrActive, y.mcrActive);
    c.value("level wait", i, x.wait, y.wait);
    c.value("level delayed", i, x.delayed, y.delayed);
    c.hex("level program mask", i, x.masks.programMask, y.masks.programMask);
    c.hex("level access mask", i, x.masks.accessMask, y.masks.accessMask);
    c.hex("level program seen", i, x.masks.programSeen, y.masks.programSeen);
    c.hex("level access seen", i, x.masks.accessSeen, y.masks.accessSeen);
    c.bytes("level start", i, x.start, y.start);
    registers(c, x.interrupted, y.interrupted);
  }
  c.value("local stacks", a.localStacks.size(), b.localStacks.size());
  for (std::size_t i = 0; i < std::min(a.localStacks.size(), b.localStacks.size()); ++i)
    c.bytes("local", i, a.localStacks[i], b.localStacks[i]);
}

void brackets(Comparison& c, const cpu::Machine& a, const cpu::Machine& b) {
  c.value("brackets", a.brackets.size(), b.brackets.size());
  for (std::size_t i = 0; i < std::min(a.brackets.size(), b.brackets.size()); ++i) {
    const cpu::Bracket &x = a.brackets[i], &y = b.brackets[i];
    c.value("bracket function", i, x.function, y.function);
    c.value("bracket rlo", i, x.rlo, y.rlo);
    c.value("bracket or", i, x.orBit, y.orBit);
    c.value("bracket er", i, x.er, y.er);
  }
  c.value("mcr active", a.mcrActive, b.mcrActive);
  c.value("mcr off", a.mcrOff, b.mcrOff);
  c.bytes("mcr stack", 0, a.mcrStack, b.mcrStack);
}

void memory(Comparison& c, const cpu::Machine& a, const cpu::Machine& b) {
  c.bytes("image", 0, a.areas.image, b.areas.image);
  c.bytes("input terminals", 0, a.areas.inputs, b.areas.inputs);
  c.bytes("output terminals", 0, a.areas.outputs, b.areas.outputs);
  const auto &x = a.dataBlocks.all(), &y = b.dataBlocks.all();
  c.value("data blocks", x.size(), y.size());
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    c.value("loaded DB", i, x[i].loaded, y[i].loaded);
    c.value("read-only DB", i, x[i].readOnly, y[i].readOnly);
    c.bytes("DB", i, x[i].data, y[i].data);
  }
}

std::string text(const cpu::S5Timer& t) {
  return fmt::format("kind {} edges {}{} started {} held {} base {} frozen {} end {}",
                     static_cast<int>(t.kind), t.startEdge, t.enableEdge, t.started, t.held, t.base,
                     t.frozen, t.end.ns);
}
std::string text(const cpu::S5Counter& n) {
  return fmt::format("{} edges {}{}{}{}", n.count, n.setEdge, n.upEdge, n.downEdge, n.enableEdge);
}

// Byte by byte first, which is fast: most of them are never used.
template <typename T>
void each(Comparison& c, std::string_view name, const std::vector<T>& a, const std::vector<T>& b) {
  if (std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0) return;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) c.value(name, i, text(a[i]), text(b[i]));
}

void requests(Comparison& c, Cpu& a, Cpu& b) {
  const std::vector<cpu::Request>&x = a.requests().waiting(), &y = b.requests().waiting();
  c.value("waiting OBs", x.size(), y.size());
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    c.value("waiting OB", i, x[i].ob, y[i].ob);
    c.bytes("waiting start", i, x[i].start, y[i].start);
  }
}

void interrupts(Comparison& c, Cpu& a, Cpu& b) {
  const cpu::Interrupts &x = a.interrupts(), &y = b.interrupts();
  for (std::size_t i = 0; i < std::min(x.cyclic.size(), y.cyclic.size()); ++i)
    c.value("next cyclic", i, x.cyclic[i].next.ns, y.cyclic[i].next.ns);
  for (std::size_t i = 0; i < std::min(x.delay.size(), y.delay.size()); ++i) {
    c.value("delay active", i, x.delay[i].active, y.delay[i].active);
    c.value("delay due", i, x.delay[i].due.ns, y.delay[i].due.ns);
  }
  for (std::size_t i = 0; i < std::min(x.timeOfDay.size(), y.timeOfDay.size()); ++i) {
    c.value("time of day active", i, x.timeOfDay[i].active, y.timeOfDay[i].active);
    c.value("time of day due", i, x.timeOfDay[i].due, y.timeOfDay[i].due);
  }
  c.bytes("locked OBs", 0, x.locked, y.locked);
  c.value("stored edges", a.moduleEvents().stored().size(), b.moduleEvents().stored().size());
}

void diagnostics(Comparison& c, const Cpu& a, const Cpu& b, std::uint64_t seen) {
  c.value("diagnostic entries", a.diagnostics().added(), b.diagnostics().added());
  const auto &x = a.diagnostics().events(), &y = b.diagnostics().events();
  const std::uint64_t added = a.diagnostics().added() - seen;
  const std::size_t from = x.size() - std::min<std::uint64_t>(x.size(), added);
  for (std::size_t i = from; i < std::min(x.size(), y.size()); ++i) {
    c.hex("diagnostic event", i, x[i].event, y[i].event);
    c.value("diagnostic time", i, x[i].time.ns, y[i].time.ns);
    c.value("diagnostic text", i, x[i].text, y[i].text);
    c.value("diagnostic place", i, x[i].place.offset, y[i].place.offset);
    if (x[i].place.block != y[i].place.block)
      c.value("diagnostic block", i, toString(x[i].place.block), toString(y[i].place.block));
    c.bytes("diagnostic info", i, x[i].info, y[i].info);
    c.bytes("diagnostic stamp", i, x[i].stamp, y[i].stamp);
  }
}

void operatingSystem(Comparison& c, const Cpu& a, const Cpu& b) {
  const cpu::Machine &x = a.machine(), &y = b.machine();
  c.value("clock", x.clock.ns, y.clock.ns);
  c.value("instructions", x.instructions, y.instructions);
  c.value("mode", static_cast<int>(a.mode()), static_cast<int>(b.mode()));
  c.value("cycles", a.cycle().count(), b.cycle().count());
  c.value("checkpoints", a.cycle().checkpoints(), b.cycle().checkpoints());
  c.value("position", x.position, y.position);
  c.value("level ended", x.levelEnded, y.levelEnded);
  c.value("stop event", a.state().stopEvent().event, b.state().stopEvent().event);
  c.value("outputs disabled", a.modules().outputsDisabled(), b.modules().outputsDisabled());
  c.value("calendar", a.clock().milliseconds(x.clock), b.clock().milliseconds(y.clock));
  c.value("longest cycle", a.cycle().times().longest, b.cycle().times().longest);
}

}  // namespace

void Comparison::line(std::string_view name, std::size_t index, std::string_view interpreted,
                      std::string_view compiled) {
  text_ +=
      fmt::format("  {} {}: interpreter {}, compiled {}\n", name, index, interpreted, compiled);
}

void Comparison::rows(std::string_view name, std::size_t index,
                      std::span<const std::uint8_t> interpreted,
                      std::span<const std::uint8_t> compiled) {
  constexpr std::size_t kRow = 16;
  for (std::size_t at = 0; at < interpreted.size(); at += kRow) {
    const std::size_t length = std::min(kRow, interpreted.size() - at);
    const auto text = [&](std::span<const std::uint8_t> all) {
      return fmt::format("{:02X}", fmt::join(all.subspan(at, length), ""));
    };
    if (text(interpreted) != text(compiled))
      line(fmt::format("{} {} byte", name, index), at, text(interpreted), text(compiled));
  }
}

std::string compare(Cpu& interpreted, Cpu& compiled, std::uint64_t seen) {
  const cpu::Machine &a = interpreted.machine(), &b = compiled.machine();
  Comparison c;
  operatingSystem(c, interpreted, compiled);
  registers(c, a.registers, b.registers);
  frames(c, a, b);
  levels(c, a, b);
  brackets(c, a, b);
  memory(c, a, b);
  each(c, "T", a.timers, b.timers);
  each(c, "Z", a.counters, b.counters);
  requests(c, interpreted, compiled);
  interrupts(c, interpreted, compiled);
  diagnostics(c, interpreted, compiled, seen);
  return c.text();
}

}  // namespace merker::differential
