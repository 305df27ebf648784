// [[plant]] of merker.toml: machines and processes and their wires to the modules.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/text.h"
#include "io/rack.h"
#include "plant/telegram.h"
#include "project/readers.h"

namespace merker::project {
namespace {

using plant::Kind;
using plant::PlantSettings;
using plant::Signal;

constexpr std::string_view kWireWords =
    "a terminal or a signal: \"Panel.DO0\", or { to = \"4.AI0\", low = 0, high = 200 }";

// Reads the plants of one file, in its order.
class Reader {
 public:
  explicit Reader(const io::Configuration& modules) : rack_(modules) {}
  // All names, in capital letters, to tell which of them stand below.
  void expect(std::set<std::string> names) { below_ = std::move(names); }
  void read(const Table& table);
  plant::Configuration take() { return std::move(plants_); }

 private:
  bool readName(const Table& table, PlantSettings& plant) const;
  void readWires(const Table& wires, PlantSettings& plant) const;
  void readWire(const Table& wires, const std::string& key, PlantSettings& plant) const;
  void readBus(const Table& wires, std::string_view key, PlantSettings& plant) const;
  std::optional<std::uint32_t> slaveModule(std::string_view slave,
                                           const plant::Telegram& telegram) const;
  bool find(const Table& table, std::string_view key, const Signal& signal,
            plant::Wire& wire) const;
  bool findTerminal(const Table& table, std::string_view key, const Signal& signal,
                    const io::TerminalName& name, plant::Wire& wire) const;
  void scale(const Table* ends, const Signal& signal, plant::Wire& wire) const;
  bool isFree(const Table& table, std::string_view key, const PlantSettings& plant,
              const plant::Wire& wire) const;

  io::Rack rack_;
  plant::Configuration plants_;
  std::set<std::string> below_;
};

const Kind* readKind(const Table& table) {
  if (!table.has("kind")) {
    table.problems().add(ProblemCode::P0760, table.place(), "kind",
                         "one of: " + plant::kindNames());
    return nullptr;
  }
  const auto name = table.text("kind", "one of: " + plant::kindNames());
  const Kind* kind = name ? plant::findKind(*name) : nullptr;
  if (name && kind == nullptr)
    table.problems().add(ProblemCode::P0761, table.at("kind"), *name, plant::kindNames());
  return kind;
}

Duration inTime(double seconds) { return {std::llround(seconds * 1e9)}; }

double readParameter(const Table& table, const plant::Parameter& parameter) {
  using Form = plant::Parameter::Form;
  if (parameter.form == Form::Number)
    return table.real(parameter.key, parameter.low, parameter.high).value_or(parameter.standard);
  if (parameter.form == Form::Flag)
    return table.flag(parameter.key).value_or(parameter.standard != 0) ? 1 : 0;
  if (parameter.form == Form::Whole)
    return static_cast<double>(
        table.integer(parameter.key, std::llround(parameter.low), std::llround(parameter.high))
            .value_or(std::llround(parameter.standard)));
  const auto length = table.length(parameter.key, inTime(parameter.low), inTime(parameter.high));
  return length ? static_cast<double>(length->ns) / 1e9 : parameter.standard;
}

void readParameters(const Table& table, PlantSettings& plant) {
  std::vector<std::string_view> keys{"name", "kind", "step", "wire"};
  for (const plant::Parameter& parameter : plant.kind->parameters) {
    keys.push_back(parameter.key);
    plant.parameters.push_back(readParameter(table, parameter));
  }
  table.allow(keys);
  plant.step = plant.kind->step;
  if (const auto step =
          table.length("step", Duration::microseconds(100), Duration::seconds(1)))  // PID-SIM-01
    plant.step = *step;
}

bool Reader::readName(const Table& table, PlantSettings& plant) const {
  if (!table.has("name"))
    table.problems().add(ProblemCode::P0760, table.place(), "name", "the name used in scenarios");
  const auto name = table.text("name", "a text");
  if (!name) return false;
  plant.name = *name;
  if (name->empty() || name->find_first_of(".\"= \t") != std::string::npos) {
    table.mustBe("name", "a word without blanks, points and quotation marks");
    return false;
  }
  if (plants_.find(*name) || rack_.module(*name)) {
    table.problems().add(ProblemCode::P0742, table.at("name"), *name,
                         plants_.find(*name) ? "another plant" : "a module");
    return false;
  }
  return true;
}

void Reader::read(const Table& table) {
  PlantSettings plant;
  const bool named = readName(table, plant);
  plant.kind = readKind(table);
  if (plant.kind == nullptr) return;
  readParameters(table, plant);
  if (const auto wires = table.table("wire")) readWires(*wires, plant);
  if (named) plants_.plants.push_back(std::move(plant));
}

void Reader::readWires(const Table& wires, PlantSettings& plant) const {
  for (const std::string& key : wires.keys()) readWire(wires, key, plant);
}

// KEY = "4.AO0", or { to = "4.AO0", low = 0, high = 200 }
void Reader::readWire(const Table& wires, const std::string& key, PlantSettings& plant) const {
  const auto number = plant.kind->signal(key);
  if (!number) {
    wires.problems().add(ProblemCode::P0762, wires.placeOf(key),
                         fmt::format("a plant of kind '{}'", plant.kind->name), key,
                         plant::signalNames(*plant.kind));
    return;
  }
  const Signal& signal = plant.kind->signals[*number];
  if (plant.kind->telegram != nullptr && signal.name == plant::kBusSignal)
    return readBus(wires, key, plant);
  plant::Wire wire;
  wire.signal = *number;
  const toml::node* node = wires.node(key);
  if (node != nullptr && node->is_table()) {
    const Table ends = *wires.table(key);
    ends.allow({"to", "low", "high"});
    if (!ends.has("to")) return ends.mustBe("to", kWireWords);
    if (!find(ends, "to", signal, wire) || !isFree(ends, "to", plant, wire)) return;
    scale(&ends, signal, wire);
  } else {
    if (!find(wires, key, signal, wire) || !isFree(wires, key, plant, wire)) return;
    scale(nullptr, signal, wire);
  }
  plant.wires.push_back(std::move(wire));
}

// BUS = "Drive": the whole telegram is wired to the module of the slave that has it.
void Reader::readBus(const Table& wires, std::string_view key, PlantSettings& plant) const {
  const plant::Telegram& telegram = *plant.kind->telegram;
  const std::string wanted =
      fmt::format("the name of a [[slave]] of type PROFIdrive with \"{}\"", telegram.name);
  const auto slave = wires.text(key, wanted);
  if (!slave) return;
  const auto module = slaveModule(*slave, telegram);
  if (!module) return wires.mustBe(key, wanted);
  for (const PlantSettings& other : plants_.plants)
    for (const plant::Wire& wire : other.wires)
      if (const auto* data = std::get_if<io::ProcessData>(&wire.end);
          data != nullptr && data->module == *module)
        return wires.problems().add(ProblemCode::P0765, wires.at(key), *slave, other.name);
  const auto add = [&](std::string_view signal, const io::ProcessData& data) {
    plant.wires.push_back({*plant.kind->signal(signal), data, *slave});
  };
  add(plant::kBusSignal, {*module, true, 0, 0});
  for (const plant::TelegramWord& word : telegram.words)
    add(word.signal, {*module, word.setpoint, word.word, word.words});
}

// The slave's module with this telegram.
std::optional<std::uint32_t> Reader::slaveModule(std::string_view slave,
                                                 const plant::Telegram& telegram) const {
  const auto head = rack_.module(slave);
  if (!head) return std::nullopt;
  const std::vector<io::Module>& modules = rack_.configuration().modules;
  for (std::uint32_t i = 0; i < modules.size(); ++i)
    if (modules[i].rack == modules[*head].rack && modules[i].type->name == telegram.name) return i;
  return std::nullopt;
}

// Two outputs at one input terminal would fight.
bool Reader::isFree(const Table& table, std::string_view key, const PlantSettings& plant,
                    const plant::Wire& wire) const {
  const auto* terminal = std::get_if<io::Terminal>(&wire.end);
  if (terminal == nullptr || plant.kind->signals[wire.signal].side == Signal::Side::Input)
    return true;
  std::string driver = plants_.driverOf(*terminal);
  if (driver.empty()) driver = plant.driverOf(*terminal);
  if (driver.empty()) return true;
  table.problems().add(ProblemCode::P0765, table.at(key), wire.text, driver);
  return false;
}

std::string titleOf(const Signal& signal) {
  return fmt::format("{} {} signal {}", signal.binary ? "the binary" : "the analog",
                     signal.side == Signal::Side::Input ? "input" : "output", signal.name);
}

// The end that a text names.
bool Reader::find(const Table& table, std::string_view key, const Signal& signal,
                  plant::Wire& wire) const {
  const auto text = table.text(key, kWireWords);
  if (!text) return false;
  wire.text = *text;
  const auto point = text->rfind('.');
  const auto other = plants_.find(std::string_view(*text).substr(0, point));
  if (point != std::string::npos && other) {
    const Kind& kind = *plants_.plants[*other].kind;
    const auto number = kind.signal(std::string_view(*text).substr(point + 1));
    if (!number)
      table.problems().add(ProblemCode::P0762, table.at(key), plants_.plants[*other].name,
                           text->substr(point + 1), plant::signalNames(kind));
    else if (signal.side == Signal::Side::Output)
      table.problems().add(ProblemCode::P0764, table.at(key), titleOf(signal), *text,
                           "a wire between plants must be defined at the plant with the input");
    else if (signal.binary != kind.signals[*number].binary)
      table.problems().add(ProblemCode::P0764, table.at(key), titleOf(signal), *text,
                           signal.binary ? "that is a number" : "that is a bit");
    else
      wire.end = plant::SignalPlace{*other, *number};
    return number && signal.side == Signal::Side::Input &&
           signal.binary == kind.signals[*number].binary;
  }
  if (below_.contains(upper(std::string_view(*text).substr(0, point)))) {
    table.problems().add(ProblemCode::P0767, table.at(key), text->substr(0, point));
    return false;
  }
  const auto name = io::parseTerminal(*text);
  if (name) return findTerminal(table, key, signal, *name, wire);
  table.problems().add(ProblemCode::P0763, table.at(key), *text);
  return false;
}

bool Reader::findTerminal(const Table& table, std::string_view key, const Signal& signal,
                          const io::TerminalName& name, plant::Wire& wire) const {
  const auto fail = [&](ProblemCode code, auto&&... words) {
    table.problems().add(code, table.at(key), words...);
    return false;
  };
  const auto module = rack_.module(name.module);
  if (!module) return fail(ProblemCode::P0763, wire.text);
  const auto terminal = rack_.terminal(name.module, name.side, name.channel);
  if (!terminal)
    return fail(ProblemCode::P0984, rack_.configuration().modules[*module].title(),
                "terminal " + wire.text.substr(wire.text.rfind('.') + 1));
  const bool fits = io::isDigital(name.side) == signal.binary &&
                    io::isOutput(name.side) == (signal.side == Signal::Side::Input);
  if (!fits)
    return fail(
        ProblemCode::P0764, titleOf(signal), wire.text,
        fmt::format("it needs {} {} terminal, {}", signal.binary ? "a digital" : "an analog",
                    signal.side == Signal::Side::Input ? "output" : "input",
                    signal.side == Signal::Side::Input ? (signal.binary ? "DO" : "AO")
                                                       : (signal.binary ? "DI" : "AI")));
  if (!signal.binary && rack_.range(*terminal) == nullptr)
    return fail(ProblemCode::P0984, wire.text, "range: it is off");
  wire.end = *terminal;
  return true;
}

// The rated ends of an analog range stand for `low` and `high` (PID-SIM-07). Temperatures are
// measured as they are; zero of a range with both signs is zero.
void Reader::scale(const Table* ends, const Signal& signal, plant::Wire& wire) const {
  const auto* terminal = std::get_if<io::Terminal>(&wire.end);
  const MeasuringRange* range = terminal ? rack_.range(*terminal) : nullptr;
  const bool given = ends != nullptr && (ends->has("low") || ends->has("high"));
  if (range == nullptr) {
    if (given)
      ends->problems().add(ProblemCode::P0744, ends->place(), "low and high",
                           "an analog terminal at the other end");
    return;
  }
  if (range->quantity == Quantity::Temperature && !given) return;
  constexpr double kMost = 1e9;
  double high = signal.high;
  if (ends != nullptr) high = ends->real("high", -kMost, kMost).value_or(high);
  double low = range->low < 0 ? -high : signal.low;
  if (ends != nullptr) low = ends->real("low", -kMost, kMost).value_or(low);
  if (low == high) {
    if (ends != nullptr) ends->mustBe("high", "different from 'low'");
    return;
  }
  wire.scale = (range->high - range->low) / (high - low);
  wire.offset = range->low - wire.scale * low;
}

}  // namespace

plant::Configuration readPlants(const Table& root, const io::Configuration& modules) {
  Reader reader(modules);
  std::set<std::string> names;
  for (const Table& table : root.tables("plant"))
    if (const toml::node* name = table.node("name"); name != nullptr && name->is_string())
      names.insert(upper(name->as_string()->get()));
  reader.expect(std::move(names));
  for (const Table& table : root.tables("plant")) reader.read(table);
  return reader.take();
}

}  // namespace merker::project
