// Which plants stand beside a station and what their signals are wired to. Made from merker.toml by
// `project`, put into operation by `Plants`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/rack.h"
#include "plant/kind.h"

namespace merker::plant {

// A signal of a plant by position: Configuration::plants and Kind::signals.
struct SignalPlace {
  std::uint32_t plant = 0, signal = 0;
};

// The end of a wire at a terminal of another station: a number in Configuration::far.
struct FarEnd {
  std::uint32_t number = 0;
};

// The other end of a wire: a terminal, for inputs the signal of another plant, of a drive at a bus
// words of its telegram.
struct Wire {
  std::uint32_t signal = 0;  // of the plant that has the wire
  std::variant<io::Terminal, SignalPlace, io::ProcessData, FarEnd> end;
  std::string text;  // as written: "4.AO0"
  // Of an analog terminal: the amount is offset + scale * value, in the range's unit.
  double scale = 1, offset = 0;
};

struct PlantSettings {
  std::string name;
  const Kind* kind = nullptr;
  Duration step;
  std::vector<double> parameters;  // in the order of the kind's row
  std::vector<Wire> wires;

  const Wire* wireOf(std::uint32_t signal) const;  // null: nothing drives it
  // "Valve.LMNR_HS", the output that drives an input terminal; empty: none.
  std::string driverOf(const io::Terminal& terminal) const;
};

// A wire to another station, which has the terminal.
struct FarWire {
  std::size_t station = 0;  // its number in the project
  std::uint32_t plant = 0, wire = 0;
};

// A terminal of this station at which the wire of another station's plant ends.
struct LentTerminal {
  std::size_t station = 0;   // of the plant
  std::uint32_t number = 0;  // of the wire among its FarWires
  io::Terminal terminal;
  std::string signal;  // "Line/Belt.FRONT"
};

// In the order of merker.toml: a plant that feeds another one stands above it.
struct Configuration {
  std::vector<PlantSettings> plants;
  std::vector<FarWire> far{};
  std::vector<LentTerminal> lent{};
  std::optional<std::uint32_t> find(std::string_view name) const;  // ignoring case
  std::string names() const;                                       // for problems
  std::string driverOf(const io::Terminal& terminal) const;
};

}  // namespace merker::plant
