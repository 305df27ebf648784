#include <algorithm>

#include "block/container.h"
#include "workbench/fields.h"
#include "workbench/hex.h"
#include "workbench/snapshot_text.h"

namespace merker::workbench {
namespace {

constexpr std::int64_t kExact = 1ll << 53;  // what JSON numbers hold
constexpr std::size_t kMostItems = 100'000, kMostBytes = 16 << 20;

// The fields of one object, with what only this file has.
struct Reader {
  const Fields& fields;

  std::int64_t time(std::string_view key) const { return fields.integer(key, -kExact, kExact); }
  bool flag(std::string_view key) const { return fields.flag(key); }
  template <typename T>
  T number(std::string_view key, std::int64_t high) const {
    return static_cast<T>(fields.integer(key, 0, high));
  }
  std::vector<std::uint8_t> bytes(std::string_view key) const {
    auto bytes = fromHex(fields.text(key));
    if (bytes && bytes->size() <= kMostBytes) return std::move(*bytes);
    fields.add(makeProblem(ProblemCode::P1305, nowhere(), fields.path(key), "hexadecimal digits"));
    return {};
  }
  template <std::size_t N>
  void into(std::string_view key, std::array<std::uint8_t, N>& to) const {
    const auto all = bytes(key);
    std::copy_n(all.begin(), std::min(all.size(), N), to.begin());
  }
};

template <typename T, typename Take>
std::vector<T> listOf(const Fields& fields, std::string_view key, Take take) {
  std::vector<T> list;
  for (const Fields& item : fields.objects(key, kMostItems)) list.push_back(take(Reader{item}));
  return list;
}

// An item may stand for several that are alike.
template <typename T, typename Take>
std::vector<T> runsOf(const Fields& fields, std::string_view key, Take take) {
  constexpr auto kMost = static_cast<std::int64_t>(kMostItems);
  std::vector<T> list;
  for (const Fields& item : fields.objects(key, kMostItems)) {
    const std::int64_t room = kMost - static_cast<std::int64_t>(list.size());
    const std::int64_t times = item.integer("times", 1, room, 1);
    list.insert(list.end(), static_cast<std::size_t>(times), take(Reader{item}));
  }
  return list;
}

block::RetentiveTimer timer(const Reader& r, std::int64_t now) {
  constexpr std::int64_t kUnits = 999, kLongest = 9'990'000'000'000;  // ns: 999 times 10 s
  block::RetentiveTimer t;
  t.kind = r.number<std::uint8_t>("kind", 4);
  t.startEdge = r.flag("startEdge");
  t.enableEdge = r.flag("enableEdge");
  t.started = r.flag("started");
  t.held = r.flag("held");
  t.base = r.number<std::uint8_t>("base", 3);
  t.frozen = r.number<std::uint16_t>("frozen", kUnits);
  constexpr std::int64_t kUnit[] = {10'000'000, 100'000'000, 1'000'000'000, 10'000'000'000};
  t.end = std::min({r.time("end"), now + kLongest, now + kUnits * kUnit[t.base]});
  return t;
}

block::RetentiveCounter counter(const Reader& r) {
  return {r.number<std::uint16_t>("count", 999), r.flag("setEdge"), r.flag("upEdge"),
          r.flag("downEdge"), r.flag("enableEdge")};
}

block::RetentiveEvent event(const Reader& r) {
  block::RetentiveEvent e;
  e.event = r.number<std::uint16_t>("event", 0xFFFF);
  e.time = r.time("time");
  e.text = r.fields.text("text").substr(0, 1000);
  r.into("info", e.info);
  r.into("stamp", e.stamp);
  if (!r.fields.has("block")) return e;
  const auto place = r.fields.integers("block", 0, 0xFFFF, 2);
  constexpr std::int64_t kCode[] = {0x08, 0x0C, 0x0E};  // OB, FC, FB
  e.placeKnown = place.size() == 2 && std::ranges::find(kCode, place[0]) != std::end(kCode);
  if (!e.placeKnown) return e;
  e.block = {static_cast<BlockKind>(place[0]), static_cast<std::uint16_t>(place[1])};
  e.offset = r.number<std::uint32_t>("offset", 0xFFFF);
  return e;
}

block::RetentiveData memory(const Fields& fields) {
  block::RetentiveData data;
  const Reader r{fields};
  data.now = r.time("now");
  data.clock = fields.integer("clock", 0, kExact);
  data.flags = r.bytes("flags");
  data.timers = runsOf<block::RetentiveTimer>(
      fields, "timers", [&](const Reader& one) { return timer(one, data.now); });
  data.counters = runsOf<block::RetentiveCounter>(fields, "counters", counter);
  data.meters = listOf<block::RetentiveMeter>(fields, "meters", [](const Reader& one) {
    return block::RetentiveMeter{one.time("counted"), one.time("since"), one.flag("running")};
  });
  data.dataBlocks = listOf<block::RetentiveDataBlock>(fields, "dataBlocks", [](const Reader& one) {
    return block::RetentiveDataBlock{one.number<std::uint16_t>("number", 0xFFFF), one.flag("made"),
                                     one.bytes("bytes")};
  });
  data.events = listOf<block::RetentiveEvent>(fields, "events", event);
  return data;
}

cpu::CyclicInterrupt cyclic(const Reader& r) {
  cpu::CyclicInterrupt one{.ob = r.number<std::uint8_t>("ob", 0xFF)};
  one.next = r.fields.has("next") ? Instant{r.time("next")} : Instant::never();
  return one;
}

cpu::DelayInterrupt delay(const Reader& r) {
  return {.ob = r.number<std::uint8_t>("ob", 0xFF),
          .active = r.flag("active"),
          .finished = r.flag("finished"),
          .sign = r.number<std::uint16_t>("sign", 0xFFFF),
          .milliseconds = r.number<std::uint32_t>("ms", 60'000),
          .due = Instant{r.time("due")}};
}

cpu::TimeOfDayInterrupt timeOfDay(const Reader& r) {
  constexpr std::int64_t kCentury = 3'155'760'000'000;  // ms
  const auto period = r.number<std::uint32_t>("period", 0xFFFF);
  if (!cpu::isPeriod(period))
    r.fields.add(makeProblem(ProblemCode::P1305, nowhere(), r.fields.path("period"), "a period"));
  return {.ob = r.number<std::uint8_t>("ob", 0xFF),
          .set = r.flag("set"),
          .active = r.flag("active"),
          .expired = r.flag("expired"),
          .period = static_cast<cpu::Period>(period),
          .start = r.number<std::int64_t>("start", kCentury),
          .due = r.fields.integer("due", -1, kCentury)};  // -1: never again
}

cpu::Interrupts interrupts(const Fields& fields) {
  cpu::Interrupts all;
  all.cyclic = listOf<cpu::CyclicInterrupt>(fields, "cyclic", cyclic);
  all.delay = listOf<cpu::DelayInterrupt>(fields, "delay", delay);
  all.timeOfDay = listOf<cpu::TimeOfDayInterrupt>(fields, "timeOfDay", timeOfDay);
  for (const std::int64_t ob : fields.integers("locked", 0, 0xFF, 0x100))
    all.locked.push_back(static_cast<std::uint8_t>(ob));
  return all;
}

void addCycle(const Fields& fields, cpu::Snapshot& s) {
  const Reader r{fields};
  s.cycleTimes = {r.number<std::int32_t>("previous", INT32_MAX),
                  r.number<std::int32_t>("shortest", INT32_MAX),
                  r.number<std::int32_t>("longest", INT32_MAX), r.flag("any")};
  s.cycleBegan = r.time("began");
  s.nextCycle = r.time("next");
}

cpu::Snapshot snapshot(const Fields& fields) {
  const Reader r{fields};
  cpu::Snapshot s;
  s.memory = memory(fields.object("memory"));
  s.images = r.bytes("images");
  s.inputs = r.bytes("inputs");
  s.outputs = r.bytes("outputs");
  s.run = r.flag("run");
  s.position = static_cast<cpu::SwitchPosition>(fields.choice("switch", {"RUN-P", "RUN", "STOP"}));
  s.stoppedByFault = r.flag("fault");
  s.timersHeld = r.flag("timersByHand");
  s.stopEvent = listOf<block::RetentiveEvent>(fields, "stop", event);
  s.interrupts = interrupts(fields.object("interrupts"));
  s.systemTime = fields.integer("systemTime", 0, kExact);
  s.scan = r.number<std::uint8_t>("scan", 4);
  addCycle(fields.object("cycle"), s);
  return s;
}

using Known = std::vector<const block::Program*>;

// A container knows neither names nor lines.
block::Block withSource(block::Block block, const std::vector<std::uint8_t>& container,
                        const Known& known) {
  for (const block::Program* program : known) {
    const auto found = program->find(block.id);
    if (found != program->end() && block::writeContainer(found->second) == container)
      return found->second;
  }
  return block;
}

std::shared_ptr<const block::Program> program(const Fields& fields, const Known& known) {
  auto result = std::make_shared<block::Program>();
  for (const Fields& item : fields.objects("blocks", kMostItems)) {
    const auto container = Reader{item}.bytes("container");
    auto block = block::readContainer(container, nowhere());
    if (!block) {
      item.add(block.error());
      continue;
    }
    block->attributes.readOnly = item.flag("readOnly");
    const BlockId id = block->id;
    result->insert_or_assign(id, withSource(std::move(*block), container, known));
  }
  return result;
}

}  // namespace

Result<SavedCpu> parseSnapshot(const std::string& path, std::string_view text, const Known& known) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("merkerCpuState"))
    return makeProblem(ProblemCode::P1320, nowhere(), path, "it is not a file written by cpu.save");
  Problems problems;
  const Fields fields(json, problems);
  fields.integer("merkerCpuState", 1, 1);
  SavedCpu saved;
  saved.model = fields.text("cpu");
  saved.hardware = fields.texts("hardware", kMostItems);
  saved.program = program(fields, known);
  saved.snapshot = snapshot(fields);
  for (const Fields& item : fields.objects("forces", kMostItems))
    saved.forces.push_back({item.text("operand"), item.text("value")});
  if (fields.good()) return saved;
  return makeProblem(ProblemCode::P1320, nowhere(), path, problems.list().front().message);
}

}  // namespace merker::workbench
