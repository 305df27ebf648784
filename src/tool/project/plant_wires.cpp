// [plant.wire] of merker.toml: where the signals of a plant are wired to.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "io/asi.h"
#include "io/slave.h"
#include "io/terminal_address.h"
#include "project/plant_reader.h"

namespace merker::project {

std::string titleOf(const plant::Signal& signal) {
  return fmt::format("{} {} signal {}", signal.binary ? "the binary" : "the analog",
                     signal.side == plant::Signal::Side::Input ? "input" : "output", signal.name);
}

namespace {

using plant::Kind;
using plant::PlantSettings;
using plant::Signal;

constexpr std::string_view kWireWords =
    "a terminal or a signal: \"Panel.DO0\", or { to = \"4.AI0\", low = 0, high = 200 }";

std::string neededBy(const Signal& signal) {
  const bool input = signal.side == Signal::Side::Input;
  return fmt::format("it needs {} {} terminal, {}", signal.binary ? "a digital" : "an analog",
                     input ? "output" : "input",
                     input ? (signal.binary ? "DO" : "AO") : (signal.binary ? "DI" : "AI"));
}

// A data bit of an AS-i slave that its profile makes no input, or no output.
bool isNone(const io::Module& module, const io::Terminal& terminal) {
  const unsigned bits = io::isOutput(terminal.side) ? module.asiOutputs : module.asiInputs;
  return module.asiCp && (bits >> terminal.channel & 1) == 0;
}

bool hasTerminals(const ModuleType& type) {
  return type.digitalInputs + type.digitalOutputs + type.analogInputs + type.analogOutputs > 0;
}

// The DP slave, a drive or an intelligent one, whose data lie at an address; empty: none.
std::string slaveOfData(const io::Configuration& configuration,
                        const io::TerminalAddress& address) {
  const auto has = [&](const io::Module& module) {
    if (module.rack < io::kSlaveRack || hasTerminals(*module.type)) return false;
    if (io::isOutput(address.side))
      return module.outputStart && address.byte >= *module.outputStart &&
             address.byte <= module.outputEnd();
    return module.inputStart && address.byte >= *module.inputStart &&
           address.byte <= module.inputEnd();
  };
  const auto data = std::ranges::find_if(configuration.modules, has);
  if (data == configuration.modules.end()) return {};
  const auto head = std::ranges::find_if(configuration.modules, [&](const io::Module& one) {
    return one.rack == data->rack && io::isHead(*one.type);
  });
  return head == configuration.modules.end() ? data->slotText() : head->name;
}

// Finds terminals in the rack of one station.
class Ends {
 public:
  Ends(const Table& table, std::string_view key, const Signal& signal, const io::Rack& rack)
      : table_(table), key_(key), signal_(signal), rack_(rack) {}

  // `end`: the text without the name of a station. Nothing, and a problem: it cannot be wired
  // there.
  std::optional<io::Terminal> find(std::string_view end, const std::string& text) const {
    const auto terminal = named(end, text);
    if (!terminal) return std::nullopt;
    const bool fits = io::isDigital(terminal->side) == signal_.binary &&
                      io::isOutput(terminal->side) == (signal_.side == Signal::Side::Input);
    if (!fits) return fail(ProblemCode::P0764, titleOf(signal_), text, neededBy(signal_));
    const io::Module& module = rack_.configuration().modules[terminal->module];
    if (isNone(module, *terminal))
      return fail(ProblemCode::P0764, titleOf(signal_), text,
                  io::isOutput(terminal->side)
                      ? fmt::format("with the profile {} of the slave this bit is no output",
                                    module.type->name)
                      : fmt::format("with the profile {} of the slave this bit is no input",
                                    module.type->name));
    if (!signal_.binary && rack_.range(*terminal) == nullptr)
      return fail(ProblemCode::P0984, text, "range: it is off");
    return terminal;
  }

 private:
  template <typename... Words>
  std::nullopt_t fail(ProblemCode code, const Words&... words) const {
    table_.problems().add(code, table_.at(key_), words...);
    return std::nullopt;
  }

  // MODULE.DI0 or E 20.0
  std::optional<io::Terminal> named(std::string_view end, const std::string& text) const {
    if (const auto address = io::parseTerminalAddress(end)) {
      const auto terminal = io::terminalAt(rack_.configuration(), *address);
      if (terminal) return terminal;
      if (const std::string slave = slaveOfData(rack_.configuration(), *address); !slave.empty())
        return fail(ProblemCode::P0764, titleOf(signal_), text,
                    fmt::format("there are data of the DP slave {} without terminals", slave));
      return fail(ProblemCode::P0984, "the hardware configuration",
                  fmt::format("terminal at {}", text));
    }
    const auto name = io::parseTerminal(end);
    const auto module = name ? rack_.module(name->module) : std::nullopt;
    if (!module) return fail(ProblemCode::P0763, text);
    const auto terminal = rack_.terminal(name->module, name->side, name->channel);
    if (!terminal)
      return fail(ProblemCode::P0984, rack_.configuration().modules[*module].title(),
                  "terminal " + text.substr(text.rfind('.') + 1));
    return terminal;
  }

  const Table& table_;
  std::string_view key_;
  const Signal& signal_;
  const io::Rack& rack_;
};

// The rated ends of an analog range stand for `low` and `high` (PID-SIM-07). Temperatures are
// measured as they are; zero of a range with both signs is zero. `range` null: no analog terminal.
void scale(const Table* ends, const Signal& signal, const MeasuringRange* range,
           plant::Wire& wire) {
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

// Two outputs at one input terminal would fight. `driver`: what drives it already, or nothing.
bool isFree(const Table& table, std::string_view key, const Signal& signal, const std::string& text,
            const std::string& driver) {
  if (signal.side == Signal::Side::Input || driver.empty()) return true;
  table.problems().add(ProblemCode::P0765, table.at(key), text, driver);
  return false;
}

}  // namespace

void PlantReader::readWires(const Table& wires, PlantSettings& plant) {
  for (const std::string& key : wires.keys()) readWire(wires, key, plant);
}

// KEY = "4.AO0", or { to = "4.AO0", low = 0, high = 200 }
void PlantReader::readWire(const Table& wires, const std::string& key, PlantSettings& plant) {
  const auto number = plant.kind->signal(key);
  if (!number) {
    wires.problems().add(ProblemCode::P0762, wires.placeOf(key),
                         fmt::format("a plant of kind '{}'", plant.kind->name), key,
                         plant::signalNames(*plant.kind));
    return;
  }
  const Signal& signal = plant.kind->signals[*number];
  if (std::ranges::count(plant.wires, *number, &plant::Wire::signal) > 0)
    return wires.problems().add(ProblemCode::P0742, wires.placeOf(key), key,
                                fmt::format("another wire of {}", signal.name));
  if (plant.kind->telegram != nullptr && signal.name == plant::kBusSignal)
    return readBus(wires, key, plant);
  plant::Wire wire;
  wire.signal = *number;
  const toml::node* node = wires.node(key);
  if (node != nullptr && node->is_table()) {
    const Table ends = *wires.table(key);
    ends.allow({"to", "low", "high"});
    if (!ends.has("to")) return ends.mustBe("to", kWireWords);
    if (!find({ends, "to", plant, signal, &ends}, wire)) return;
  } else if (!find({wires, key, plant, signal, nullptr}, wire)) {
    return;
  }
  plant.wires.push_back(std::move(wire));
}

// BUS = "Drive": the whole telegram is wired to the module of the slave that has it.
void PlantReader::readBus(const Table& wires, std::string_view key, PlantSettings& plant) const {
  const plant::Telegram& telegram = *plant.kind->telegram;
  const std::string wanted =
      fmt::format("the name of a [[slave]] of type PROFIdrive with \"{}\"", telegram.name);
  const auto slave = wires.text(key, wanted);
  if (!slave) return;
  const auto module = slaveModule(*slave, telegram);
  if (!module && wires.problems().hasErrors()) return;  // the slave may be what is wrong
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
std::optional<std::uint32_t> PlantReader::slaveModule(std::string_view slave,
                                                      const plant::Telegram& telegram) const {
  const auto head = rack_.module(slave);
  if (!head) return std::nullopt;
  const std::vector<io::Module>& modules = rack_.configuration().modules;
  for (std::uint32_t i = 0; i < modules.size(); ++i)
    if (modules[i].rack == modules[*head].rack && modules[i].type->name == telegram.name) return i;
  return std::nullopt;
}

// The signal of another plant.
bool PlantReader::findSignal(const Asked& asked, std::uint32_t other, plant::Wire& wire) const {
  const Kind& kind = *plants_.plants[other].kind;
  const std::string name = wire.text.substr(wire.text.rfind('.') + 1);
  const auto number = kind.signal(name);
  const auto fail = [&](ProblemCode code, auto&&... words) {
    asked.table.problems().add(code, asked.table.at(asked.key), words...);
    return false;
  };
  if (!number)
    return fail(ProblemCode::P0762, plants_.plants[other].name, name, plant::signalNames(kind));
  if (asked.signal.side == Signal::Side::Output)
    return fail(ProblemCode::P0764, titleOf(asked.signal), wire.text,
                "a wire between plants must be defined at the plant with the input");
  if (asked.signal.binary != kind.signals[*number].binary)
    return fail(ProblemCode::P0764, titleOf(asked.signal), wire.text,
                asked.signal.binary ? "that is a number" : "that is a bit");
  wire.end = plant::SignalPlace{other, *number};
  scale(asked.ends, asked.signal, nullptr, wire);
  return true;
}

// The end that a text names.
bool PlantReader::find(const Asked& asked, plant::Wire& wire) {
  const auto text = asked.table.text(asked.key, kWireWords);
  if (!text) return false;
  wire.text = *text;
  std::string_view end = *text;
  const auto station = otherStation(end);
  const bool here = !station || *station == own_;
  const std::string_view front = end.substr(0, end.rfind('.'));
  if (front.size() < end.size()) {
    const auto other = here ? plants_.find(front) : std::nullopt;
    if (other) return findSignal(asked, *other, wire);
    if (here && cannotFeed(asked, front, wire)) return false;
    const bool module = here && rack_.module(front);
    if (!module && isOfOthers(asked, station, front, wire)) return false;
  }
  if (!here) return findThere(asked, *station, end, wire);
  return !isStrange(asked, end) && findHere(asked, end, wire);
}

bool PlantReader::findHere(const Asked& asked, std::string_view end, plant::Wire& wire) const {
  const auto terminal = Ends(asked.table, asked.key, asked.signal, rack_).find(end, wire.text);
  if (!terminal) return false;
  std::string driver = plants_.driverOf(*terminal);
  if (driver.empty()) driver = asked.plant.driverOf(*terminal);
  if (!isFree(asked.table, asked.key, asked.signal, wire.text, driver)) return false;
  scale(asked.ends, asked.signal, rack_.range(*terminal), wire);
  wire.end = *terminal;
  return true;
}

// Another station lends its terminal.
bool PlantReader::findThere(const Asked& asked, std::size_t station, std::string_view end,
                            plant::Wire& wire) {
  const StationField& there = (*stations_)[station];
  if (there.hardware == nullptr) {
    asked.table.mustBe(asked.key, "a terminal of a SIMATIC S7; a SINUMERIK has none");
    return false;
  }
  const io::Rack rack(*there.hardware);
  const auto terminal = Ends(asked.table, asked.key, asked.signal, rack).find(end, wire.text);
  if (!terminal ||
      !isFree(asked.table, asked.key, asked.signal, wire.text, there.plants->driverOf(*terminal)))
    return false;
  if (asked.plant.kind->fast && asked.signal.side == Signal::Side::Output) {
    asked.table.problems().add(ProblemCode::P0764, asked.table.at(asked.key), titleOf(asked.signal),
                               wire.text,
                               "fast signals need a terminal of the plant's own station");
    return false;
  }
  scale(asked.ends, asked.signal, rack.range(*terminal), wire);
  const auto number = static_cast<std::uint32_t>(plants_.far.size());
  wire.end = plant::FarEnd{number};
  plants_.far.push_back({station, static_cast<std::uint32_t>(plants_.plants.size()),
                         static_cast<std::uint32_t>(asked.plant.wires.size())});
  there.plants->lent.push_back(
      {own_, number, *terminal,
       fmt::format("{}/{}.{}", (*stations_)[own_].name, asked.plant.name, asked.signal.name)});
  return true;
}

}  // namespace merker::project
