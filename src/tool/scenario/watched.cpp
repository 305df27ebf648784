#include "scenario/watched.h"

#include <algorithm>

#include "base/text.h"
#include "scenario/line.h"

namespace merker::simulator {
namespace {

void readOperand(std::string_view part, const Position& position, const Resolver& resolver,
                 std::vector<address::Reference>& operands, Problems& problems) {
  Term term{std::string(part), position, {}, {}, {}};
  if (part.empty())
    problems.add(ProblemCode::P0952, term.position, "an operand");
  else if (auto problem = resolveOperand(term, resolver))
    problems.add(*problem);
  else if (term.reference.operand.kind != address::OperandKind::Memory)
    term.reference.operand.width = Width::Word;
  operands.push_back(term.reference);
}

}  // namespace

bool Watched::movesByItself() const {
  return !plants.empty() || !terminals.empty() ||
         std::ranges::any_of(operands, [](const address::Reference& one) {
           return one.operand.area == Area::Peripheral;
         });
}

void readWatchable(std::string_view part, const Position& position, const Watchable& from,
                   Watched& watched, Problems& problems) {
  const auto at = [&](std::string_view) { return position; };
  std::string_view name = part;
  const std::string_view word = takeWord(name);
  if (equalsIgnoreCase(word, "plant") && !name.empty()) {
    PlantValue signal;
    if (!parsePlant(name, "0", signal, at, problems)) return;
    resolve(signal, &from.plants, problems);
    watched.plants.push_back(std::move(signal));
  } else if (equalsIgnoreCase(word, "terminal") && !name.empty()) {
    TerminalValue terminal;
    if (!parseTerminal(name, {}, terminal, at, problems)) return;
    resolvePlace(terminal, from.hardware, problems);
    watched.terminals.push_back(std::move(terminal));
  } else if (namesAxis(part)) {
    AxisTerm term;
    if (!parseAxis(part, {}, term, at, problems)) return;
    resolve(term, from.hardware, problems);
    watched.axis.push_back(std::move(term));
  } else {
    readOperand(part, position, from.resolver, watched.operands, problems);
  }
}

}  // namespace merker::simulator
