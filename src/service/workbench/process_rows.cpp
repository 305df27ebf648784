#include "workbench/process_rows.h"

#include "workbench/terminal_operand.h"

namespace merker::workbench {
namespace {

using plant::Signal;

struct Rows {
  const plant::Field& field;
  const source::SymbolTable& symbols;
  const plant::Plants& plants;
  const plant::PlantSettings& settings;
  std::uint32_t plant;

  const Signal& signal(std::uint32_t number) const { return settings.kind->signals[number]; }
  bool isInput(std::uint32_t number) const { return signal(number).side == Signal::Side::Input; }
  Json value(std::uint32_t number) const;
  Json fault(std::uint32_t number) const;
};

Json numberOrNull(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

// Terminals are looked at by their operands; wires between plants have none.
TerminalOperand operandOf(const Rows& rows, const plant::Wire* wire) {
  if (wire == nullptr) return {};
  const auto* terminal = std::get_if<io::Terminal>(&wire->end);
  if (terminal == nullptr) return {};
  return terminalOperand(rows.field.rack()->configuration(), *terminal, rows.symbols);
}

Json Rows::value(std::uint32_t number) const {
  const Signal& signal = this->signal(number);
  const plant::Wire* wire = settings.wireOf(number);
  const TerminalOperand operand = operandOf(*this, wire);
  return {{"name", signal.name},
          {"unit", signal.unit},
          {"value", plants.value({plant, number})},
          {"binary", signal.binary},
          {"input", isInput(number)},
          {"writable", isInput(number) && wire == nullptr},
          {"min", signal.binary ? 0 : signal.low},
          {"max", signal.binary ? 1 : signal.high},
          {"operand", operand.operand},
          {"symbol", operand.symbol},
          {"stuck", numberOrNull(plants.stuck({plant, number}))}};
}

Json Rows::fault(std::uint32_t number) const {
  return {{"name", signal(number).name},
          {"title", fmt::format("{} stuck", signal(number).name)},
          {"on", plants.stuck({plant, number}).has_value()}};
}

// As merker.toml sets them: times in seconds, true and false as 1 and 0.
Json parametersOf(const plant::PlantSettings& settings) {
  Json list = Json::object();
  for (std::size_t i = 0; i < settings.parameters.size(); ++i)
    list[std::string(settings.kind->parameters[i].key)] = settings.parameters[i];
  return list;
}

Json rowOf(const Rows& rows) {
  Json values = Json::array(), faults = Json::array();
  for (std::uint32_t i = 0; i < rows.settings.kind->signals.size(); ++i) {
    values.push_back(rows.value(i));
    if (rows.settings.wireOf(i) != nullptr) faults.push_back(rows.fault(i));
  }
  return {{"name", rows.settings.name},  {"kind", rows.settings.kind->name},
          {"title", rows.settings.name}, {"parameters", parametersOf(rows.settings)},
          {"values", std::move(values)}, {"faults", std::move(faults)}};
}

}  // namespace

Json plantRows(const plant::Field& field, const source::SymbolTable& symbols) {
  Json list = Json::array();
  const plant::Plants* plants = field.plants();
  if (plants == nullptr) return list;
  const auto& all = plants->configuration().plants;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    list.push_back(rowOf({field, symbols, *plants, all[i], i}));
  return list;
}

Json plantKindRows() {
  constexpr std::string_view kForms[] = {"number", "time", "whole", "flag"};
  Json rows = Json::array();
  for (const plant::Kind* kind : plant::kinds()) {
    Json parameters = Json::array(), signals = Json::array();
    for (const plant::Parameter& one : kind->parameters)
      parameters.push_back({{"key", one.key},
                            {"form", kForms[static_cast<std::size_t>(one.form)]},
                            {"standard", one.standard},
                            {"min", one.low},
                            {"max", one.high}});
    for (const plant::Signal& one : kind->signals)
      signals.push_back({{"name", one.name},
                         {"input", one.side == plant::Signal::Side::Input},
                         {"binary", one.binary},
                         {"unit", one.unit}});
    rows.push_back({{"name", kind->name},
                    {"parameters", std::move(parameters)},
                    {"signals", std::move(signals)}});
  }
  return rows;
}

Json plantValues(const plant::Plants& plants) {
  Json result = Json::object();
  const auto& all = plants.configuration().plants;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    Json& values = result[all[i].name] = Json::object();
    for (std::uint32_t s = 0; s < all[i].kind->signals.size(); ++s)
      values[std::string(all[i].kind->signals[s].name)] = plants.value({i, s});
  }
  return result;
}

Json plantFaults(const plant::Plants& plants) {
  Json result = Json::object();
  const auto& all = plants.configuration().plants;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    for (std::uint32_t s = 0; s < all[i].kind->signals.size(); ++s)
      if (const auto value = plants.stuck({i, s}))
        result[all[i].name][std::string(all[i].kind->signals[s].name)] = *value;
  return result;
}

}  // namespace merker::workbench
