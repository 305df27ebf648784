// terminal MODULE.DI0 = 1, …: signals at terminals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "plant/field.h"
#include "scenario/steps/bare.h"
#include "scenario/terminal_value.h"

namespace merker::simulator::steps {

struct Terminal {
  static constexpr std::string_view kWords = "terminal";

  std::vector<TerminalValue> values;

  bool parse(const StepLine& line) {
    for (const std::string_view part : splitList(line.rest())) {
      const auto sign = findOutside(part, [](std::string_view tail) { return tail[0] == '='; });
      if (sign == std::string_view::npos)
        return line.fail(ProblemCode::P0952, part, "MODULE.DI0 = VALUE");
      if (!parseTerminal(trim(part.substr(0, sign)), trim(part.substr(sign + 1)),
                         values.emplace_back(), line.positions(), line.problems()))
        return false;
    }
    return true;
  }
  void resolve(const StepBinding& binding) {
    for (TerminalValue& value : values)
      simulator::resolve(value, binding.hardware, binding.problems);
  }
  bool perform(StepRun& run) const {
    auto* const field = run.need<plant::Field>();
    if (field == nullptr) return false;
    for (const TerminalValue& value : values) {
      const std::string reason = set(value, *field->rack(), run.plc().now());
      if (!reason.empty()) return run.failAt(value.position, reason);
    }
    return true;
  }
};

}  // namespace merker::simulator::steps
