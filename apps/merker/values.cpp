#include "values.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "compilation/existence.h"
#include "output.h"
#include "scenario/display.h"

namespace merker::app {
namespace {

std::string_view modeWord(controller::Mode mode) {
  constexpr std::string_view kNames[] = {"STOP", "STARTUP", "RUN", "HALT"};
  return kNames[static_cast<std::size_t>(mode)];
}

}  // namespace

void printValues(const simulator::Watched& wanted, const controller::Controller& plc) {
  for (const address::Reference& operand : wanted.operands)
    std::cout << operand.text << " = " << simulator::show(operand, plc).value_or("?") << '\n';
  const auto* field = controller::capability<plant::Field>(plc);
  for (const simulator::PlantValue& signal : wanted.plants)
    std::cout << "plant " << signal.text << " = " << actualValue(signal, *field->plants()) << '\n';
  for (const simulator::TerminalValue& terminal : wanted.terminals)
    std::cout << "terminal " << terminal.text << " = " << actualValue(terminal, *field->rack())
              << '\n';
  for (const simulator::AxisTerm& term : wanted.axis)
    std::cout << term.text << " = " << actualValue(term, simulator::axisOf(plc)) << '\n';
}

void addState(const controller::Controller& plc, nlohmann::ordered_json& object) {
  object["mode"] = modeWord(plc.mode());
  object["fault"] = plc.stoppedByFault();
  object["seconds"] = static_cast<double>(plc.now().ns) / 1e9;
  object["cycles"] = plc.cycles();
  object["instructions"] = plc.instructions();
  if (plc.mode() == controller::Mode::Stop) object["stop_reason"] = plc.stopReason();
}

void addValues(const simulator::Watched& wanted, const controller::Controller& plc,
               nlohmann::ordered_json& object) {
  for (const address::Reference& operand : wanted.operands)
    object[operand.text] = toJson(operand, plc);
  const auto* field = controller::capability<plant::Field>(plc);
  for (const simulator::PlantValue& signal : wanted.plants)
    object["plant " + signal.text] = field->plants()->value(signal.place);
  for (const simulator::TerminalValue& terminal : wanted.terminals)
    object["terminal " + terminal.text] = presentValue(terminal, *field->rack());
  for (const simulator::AxisTerm& term : wanted.axis)
    object[term.text] = positioning::read(*term.what, simulator::axisOf(plc));
}

bool allExist(const std::vector<address::Reference>& operands, const controller::Controller& plc) {
  bool all = true;
  for (const address::Reference& operand : operands) {
    if (compilation::exists(operand, plc)) continue;
    std::cerr << "merker run: --print: " << operand.text
              << " does not exist: " << plc.whyMissing(operand) << '\n';
    all = false;
  }
  return all;
}

}  // namespace merker::app
