#include "workbench/slave_rows.h"

#include "io/asi.h"
#include "io/slave.h"
#include "monitor/symbol_name.h"
#include "workbench/hardware_rows.h"

namespace merker::workbench {
namespace {

// One direction of the four data bits of an AS-i slave.
struct AsiSide {
  std::string_view text, bit, byte;
  Area area;
  bool output;
};
constexpr AsiSide kAsiInputs{"DI", "E", "PEB", Area::Input, false};
constexpr AsiSide kAsiOutputs{"DO", "A", "PAB", Area::Output, true};

// Beyond the process image only the whole byte has a name.
Json asiTerminal(const AsiSide& side, std::uint32_t byte, std::uint32_t channel, std::uint32_t bit,
                 bool inImage, const source::SymbolTable& symbols) {
  const auto* const symbol =
      inImage ? monitor::findSymbol(address::memory(side.area, Width::Bit, 8 * byte + bit),
                                    side.output, symbols)
              : nullptr;
  return {{"text", inImage ? fmt::format("{}{}", side.text, channel)
                           : fmt::format("{}{} = .{}", side.text, channel, bit)},
          {"operand", inImage ? fmt::format("{} {}.{}", side.bit, byte, bit)
                              : fmt::format("{} {}", side.byte, byte)},
          {"symbol", symbol == nullptr ? "" : symbol->name}};
}

// Where its bits lie in the bytes of the CP.
Json asiTerminals(const io::Module& slave, const io::Configuration& configuration,
                  const source::SymbolTable& symbols) {
  Json list = Json::array();
  const io::Module& cp = configuration.modules[*slave.asiCp];
  const auto add = [&](const AsiSide& side, std::optional<std::uint32_t> start, unsigned bits) {
    if (!start) return;
    const std::uint32_t byte = *start + io::asiByte(slave.slot);
    const bool inImage = byte < configuration.model->imageBytes;
    for (std::uint32_t i = 0; i < io::kAsiBits; ++i)
      if ((bits >> i & 1) != 0)
        list.push_back(asiTerminal(side, byte, i, io::asiShift(slave.slot) + i, inImage, symbols));
  };
  add(kAsiInputs, cp.inputStart, slave.asiInputs);
  add(kAsiOutputs, cp.outputStart, slave.asiOutputs);
  return list;
}

// A rack that is none: a bus, and where it begins.
Json busOf(const io::Module& module, const io::Configuration& configuration) {
  const bool asi = module.asiCp.has_value();
  return {{"rack", module.rack},
          {"bus", asi ? "asi" : "profibus"},
          {"place", asi ? configuration.modules[*module.asiCp].slotText()
                        : std::to_string(module.rack - io::kSlaveRack)},
          {"slots", Json::array()}};
}

}  // namespace

void addSlaveRows(Json& racks, const io::Rack& rack, const source::SymbolTable& symbols) {
  const io::Configuration& configuration = rack.configuration();
  std::map<std::uint32_t, Json> buses;  // by the number of the rack that they would be
  for (const io::Module& module : configuration.modules) {
    if (module.rack < io::kAsiRack) continue;
    Json& bus = buses[module.rack];
    if (bus.is_null()) bus = busOf(module, configuration);
    Json row = moduleRow(module, &rack, symbols);
    if (module.asiCp) row["terminals"] = asiTerminals(module, configuration, symbols);
    bus["slots"].push_back(std::move(row));
  }
  for (auto& [number, bus] : buses) racks.push_back(std::move(bus));
}

}  // namespace merker::workbench
