#include <fmt/format.h>

#include "block/container.h"
#include "workbench/hex.h"
#include "workbench/snapshot_text.h"

namespace merker::workbench {
namespace {

// A UDT exists in the project only.
Result<Json> blocks(const std::string& path, const block::Program& program, std::size_t most) {
  Json list = Json::array();
  std::size_t digits = 0;
  for (const auto& [id, block] : program) {
    if (id.kind == BlockKind::UDT) continue;
    const auto container = block::writeContainer(block);
    if (container.empty()) return makeProblem(ProblemCode::P1008, nowhere(), toString(id));
    digits += 2 * container.size();
    if (digits > most) return tooLong(path, most);
    list.push_back({{"block", toString(id)},
                    {"readOnly", block.attributes.readOnly},
                    {"container", toHex(container)}});
  }
  return list;
}

Json timerJson(const block::RetentiveTimer& t) {
  return {{"kind", t.kind},
          {"startEdge", t.startEdge},
          {"enableEdge", t.enableEdge},
          {"started", t.started},
          {"held", t.held},
          {"base", t.base},
          {"frozen", t.frozen},
          {"end", t.end}};
}

Json counterJson(const block::RetentiveCounter& c) {
  return {{"count", c.count},
          {"setEdge", c.setEdge},
          {"upEdge", c.upEdge},
          {"downEdge", c.downEdge},
          {"enableEdge", c.enableEdge}};
}

Json eventJson(const block::RetentiveEvent& e) {
  Json json = {{"event", e.event},
               {"time", e.time},
               {"text", e.text},
               {"info", toHex(e.info)},
               {"stamp", toHex(e.stamp)}};
  if (!e.placeKnown) return json;
  json["block"] = {static_cast<unsigned>(e.block.kind), e.block.number};
  json["offset"] = e.offset;
  return json;
}

template <typename T, typename Show>
Json listOf(const std::vector<T>& values, Show show) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(show(value));
  return list;
}

// What is alike stands there once: a generic CPU has 65,536 timers, and a program needs few.
template <typename T, typename Show>
Json runsOf(const std::vector<T>& values, Show show) {
  Json list = Json::array();
  for (std::size_t at = 0; at < values.size();) {
    const std::size_t begin = at;
    while (at < values.size() && values[at] == values[begin]) ++at;
    list.push_back(show(values[begin]));
    if (at - begin > 1) list.back()["times"] = at - begin;
  }
  return list;
}

Json memory(const block::RetentiveData& data) {
  const auto meter = [](const block::RetentiveMeter& m) -> Json {
    return {{"counted", m.counted}, {"since", m.since}, {"running", m.running}};
  };
  const auto block = [](const block::RetentiveDataBlock& b) -> Json {
    return {{"number", b.number}, {"made", b.madeByProgram}, {"bytes", toHex(b.bytes)}};
  };
  return {{"now", data.now},
          {"clock", data.clock},
          {"flags", toHex(data.flags)},
          {"timers", runsOf(data.timers, timerJson)},
          {"counters", runsOf(data.counters, counterJson)},
          {"meters", listOf(data.meters, meter)},
          {"dataBlocks", listOf(data.dataBlocks, block)},
          {"events", listOf(data.events, eventJson)}};
}

Json interrupts(const cpu::Interrupts& all) {
  const auto cyclic = [](const cpu::CyclicInterrupt& one) -> Json {
    const bool never = one.next == Instant::never();
    return {{"ob", one.ob}, {"next", never ? Json(nullptr) : Json(one.next.ns)}};
  };
  const auto delay = [](const cpu::DelayInterrupt& one) -> Json {
    return {{"ob", one.ob},     {"active", one.active},   {"finished", one.finished},
            {"sign", one.sign}, {"ms", one.milliseconds}, {"due", one.due.ns}};
  };
  const auto time = [](const cpu::TimeOfDayInterrupt& one) -> Json {
    return {{"ob", one.ob},
            {"set", one.set},
            {"active", one.active},
            {"expired", one.expired},
            {"start", one.start},
            {"due", one.due},
            {"period", static_cast<unsigned>(one.period)}};
  };
  return {{"cyclic", listOf(all.cyclic, cyclic)},
          {"delay", listOf(all.delay, delay)},
          {"timeOfDay", listOf(all.timeOfDay, time)},
          {"locked", all.locked}};
}

}  // namespace

Problem tooLong(const std::string& path, std::size_t most) {
  return makeProblem(
      ProblemCode::P1308, nowhere(), path,
      fmt::format("it would have more than the {} MB that can be read again", most >> 20));
}

Result<std::string> snapshotText(const std::string& path, const SavedCpu& saved, std::size_t most) {
  auto program = blocks(path, *saved.program, most);
  if (!program) return program.error();
  constexpr std::string_view kPositions[] = {"RUN-P", "RUN", "STOP", "MRES"};
  const cpu::Snapshot& s = saved.snapshot;
  const auto force = [](const SavedForce& one) -> Json {
    return {{"operand", one.operand}, {"value", one.value}};
  };
  const Json json = {{"merkerCpuState", 1},
                     {"cpu", saved.model},
                     {"hardware", saved.hardware},
                     {"blocks", std::move(*program)},
                     {"memory", memory(s.memory)},
                     {"images", toHex(s.images)},
                     {"inputs", toHex(s.inputs)},
                     {"outputs", toHex(s.outputs)},
                     {"run", s.run},
                     {"switch", kPositions[static_cast<std::size_t>(s.position)]},
                     {"fault", s.stoppedByFault},
                     {"timersByHand", s.timersHeld},
                     {"stop", listOf(s.stopEvent, eventJson)},
                     {"interrupts", interrupts(s.interrupts)},
                     {"systemTime", s.systemTime},
                     {"scan", s.scan},
                     {"cycle",
                      {{"previous", s.cycleTimes.previous},
                       {"shortest", s.cycleTimes.shortest},
                       {"longest", s.cycleTimes.longest},
                       {"any", s.cycleTimes.any},
                       {"began", s.cycleBegan},
                       {"next", s.nextCycle}}},
                     {"forces", listOf(saved.forces, force)}};
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (text.size() > most) return tooLong(path, most);
  return text;
}

}  // namespace merker::workbench
