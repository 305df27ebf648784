#include <fmt/format.h>

#include <memory>
#include <random>
#include <span>

#include "case.h"
#include "control/compiled_code.h"
#include "softplc/plc.h"

namespace merker::differential5 {
namespace {

using sinumerik::Machine;
using sinumerik::Plc;

constexpr int kStops = 12;
constexpr unsigned kTerminals = 8;  // bytes of inputs that change

sinumerik::Options optionsOf(const Case& c, std::mt19937& random) {
  sinumerik::Options options;
  options.program = c.program;
  if (random() % 4 == 0) options.variant = mc5::Variant::Cop;
  options.machineData =
      sinumerik::MachineData::standard(c.program.contains({mc5::BlockType::Ob, 2}));
  if (random() % 8 == 0) options.machineData->setBit(sinumerik::data_bit::kChopping, true);
  const bool system = random() % 2 == 0;  // LIR, TIR, TNB, TNW, whichever bit allows them
  for (const unsigned bit : {4u, 5u}) options.machineData->setBit({2003, bit}, system);
  return options;
}

// Everything in the order in which it is compared, line by line.
class Picture {
 public:
  explicit Picture(const Plc& plc) {
    const auto& os = plc.operatingSystem();
    add("clock", plc.now().ns);
    add("instructions", plc.instructions());
    add("cycles", plc.cycles());
    add("mode", static_cast<int>(plc.mode()));
    text("reason " + plc.stopReason());
    const sinumerik::RunTimes& times = os.runTimes();
    for (const Duration time : {times.cycle.cyclic, times.cycle.alarm, times.alarmWindow(),
                                times.third, times.raster, times.lastRaster})
      add("run time", time.ns);
    for (const auto word : os.record().fineCode().words) add("fine code", word);
    for (const auto& entry : plc.diagnostics())
      text(std::to_string(entry.time.ns) + ' ' + entry.text);
    machine(plc.machine());
  }

  std::string difference(const Picture& other) const {
    for (std::size_t i = 0; i < std::min(lines_.size(), other.lines_.size()); ++i)
      if (lines_[i] != other.lines_[i])
        return fmt::format("{}: '{}', compiled '{}'\n", i, lines_[i].shown(),
                           other.lines_[i].shown());
    return lines_.size() == other.lines_.size() ? "" : "one has more to show\n";
  }

 private:
  template <typename Number>
  void add(std::string_view what, Number number) {
    lines_.push_back({std::string(what), {}, static_cast<std::int64_t>(number)});
  }
  // Numbers stay as they are: most pictures are the same, and nobody reads them.
  void all(std::string_view what, std::span<const std::uint8_t> numbers) {
    lines_.push_back({std::string(what), {numbers.begin(), numbers.end()}});
  }
  void all(std::string_view what, std::span<const std::uint16_t> numbers) {
    lines_.push_back({std::string(what), {numbers.begin(), numbers.end()}});
  }
  void text(std::string line) { lines_.push_back({std::move(line), {}}); }

  void level(const sinumerik::Level& l) {
    add("OB", l.ob);
    for (const sinumerik::Frame& f : l.frames)
      text(fmt::format("block {} {} at {} next {} list {} DB {} {} {} {}",
                       static_cast<int>(f.block.type), f.block.number, f.start, f.next,
                       f.parameters, f.data.open, f.data.number, f.data.start, f.data.length));
    const sinumerik::Registers& r = l.registers;
    text(fmt::format("akku {:08X} {:08X} displays {:08b}", r.akku1, r.akku2, r.displays.byte()));
    for (const sinumerik::Bracket& b : r.brackets)
      text(fmt::format("bracket {} {} {}", b.vke, b.orBit, b.isOr));
  }

  void machine(const Machine& m) {
    for (const sinumerik::Level& one : m.levels) level(one);
    all("inputs", m.inputs);
    all("outputs", m.outputs);
    all("flags", m.flags);
    all("terminals", m.periphery.outputs);
    for (const auto& timer : m.timers) add("timer", timer.word());
    for (const auto& counter : m.counters) add("counter", counter.word());
    const auto& data = m.blocks.data();
    all("data", std::span(data).first(std::min<std::size_t>(data.size(), 400)));
    all("code", std::span(m.blocks.program()).first(m.blocks.programUsed()));
  }

  struct Line {
    std::string text;
    std::vector<std::uint16_t> numbers;
    std::int64_t number = 0;
    bool operator==(const Line&) const = default;
    std::string shown() const {
      return fmt::format("{} {} {:02X}", text, number, fmt::join(numbers, " "));
    }
  };
  std::vector<Line> lines_;
};

// Mostly a little behind the next sampling, where cycles and alarm levels begin.
Instant nextStop(const Plc& plc, std::mt19937& random) {
  const auto within = Duration{static_cast<std::int64_t>(random() % 300'000)};
  if (random() % 4 == 0) return plc.now() + within;
  if (random() % 4 == 0) return plc.now() + Duration::milliseconds(random() % 30) + within;
  return std::max(plc.now(), plc.operatingSystem().schedule().nextSample()) + within;
}

// Looks at a block, which is then the processor's; the program does not notice.
class Onlooker : public sinumerik::Probe {
 public:
  bool before(const Machine&, const sinumerik::CodePlace&) override { return false; }
  void after(const Machine&, const sinumerik::CodePlace&, const sinumerik::Passed&) override {}
  // At every third stop at one of the blocks, at the next one at none.
  void look(Plc& plc, std::uint32_t stop) {
    const auto block = std::next(plc.program().begin(),
                                 static_cast<std::ptrdiff_t>(stop / 3 % plc.program().size()));
    if (stop % 3 != 2) plc.probe(block->first, stop % 3 == 0 ? this : nullptr);
  }
};

}  // namespace

Outcome run(const Case& c, std::optional<icode::Opcode> broken) {
  std::mt19937 random(c.seed);
  sinumerik::Options options = optionsOf(c, random);
  Plc reference(options);
  cnc::CompiledCode engine({.broken = broken});
  options.engine = &engine;
  engine.on = true;
  Onlooker onlooker;
  Plc compiled(options);
  for (Plc* plc : {&reference, &compiled}) plc->coldStart();
  Outcome outcome;
  for (int stop = 0; stop < kStops && outcome.difference.empty(); ++stop) {
    const Instant until = nextStop(reference, random);
    for (Plc* plc : {&reference, &compiled}) plc->advanceTo(until);
    outcome.difference = Picture(reference).difference(Picture(compiled));
    if (reference.mode() == sinumerik::Mode::Stop) break;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t byte = random() % kTerminals, value = random() & 0xFF;
      address::Reference input;
      input.operand = address::memory(Area::Input, Width::Byte, bitAddress(byte));
      for (Plc* plc : {&reference, &compiled}) plc->write(input, value);
    }
    engine.on = random() % 8 != 0;
    if (c.watched) onlooker.look(compiled, static_cast<std::uint32_t>(stop));
  }
  outcome.instructions = reference.instructions();
  outcome.compiled = engine.instructions();
  return outcome;
}

Outcome runQuiet(const Case& c, bool compiled) {
  constexpr int kLongStops = 5;
  std::mt19937 random(c.seed);
  const sinumerik::Options options = optionsOf(c, random);
  struct Side {
    cnc::CompiledCode engine;
    std::unique_ptr<Plc> plc;
  };
  Side sides[2];
  for (Side& side : sides) {
    sinumerik::Options own = options;
    own.engine = &side.engine;
    side.engine.on = compiled;
    side.plc = std::make_unique<Plc>(own);
    side.plc->passOverQuietCycles(&side == &sides[0]);
    side.plc->coldStart();
  }
  Plc &passing = *sides[0].plc, &computing = *sides[1].plc;
  Outcome outcome;
  for (int stop = 0; stop < kLongStops && outcome.difference.empty(); ++stop) {
    const Instant until = computing.now() + Duration::milliseconds(random() % 1'500) +
                          Duration{static_cast<std::int64_t>(random() % 1'000'000)};
    for (Plc* plc : {&passing, &computing}) plc->advanceTo(until);
    outcome.difference = Picture(passing).difference(Picture(computing));
    if (computing.mode() == sinumerik::Mode::Stop) break;
    if (random() % 3 == 0) continue;  // goes on as it is
    const std::uint32_t byte = random() % kTerminals, value = random() & 0xFF;
    address::Reference input;
    input.operand = address::memory(Area::Input, Width::Byte, bitAddress(byte));
    for (Plc* plc : {&passing, &computing}) plc->write(input, value);
  }
  outcome.cycles = computing.cycles();
  outcome.passed = passing.operatingSystem().quiet().cycles();
  return outcome;
}

}  // namespace merker::differential5
