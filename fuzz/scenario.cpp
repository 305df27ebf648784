// Scenarios: any text is read into steps or refused with problems that can be shown.
#include "scenario/scenario.h"

#include "harness.h"
#include "step7/compiler.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text(data, size);
  const source::SourceFile file("a.scn", toUtf8(bytes, detectEncoding(bytes)));
  Problems problems;
  auto scenarios = simulator::parseScenarios(file, problems);
  const block::Program program;
  const auto resolver = [&](std::string_view text, const Position& at) {
    return step7::resolve(text, program, {}, at);
  };
  for (simulator::Scenario& scenario : scenarios) simulator::resolve(scenario, resolver, problems);
  for (const Problem& problem : problems.list()) (void)source::format(problem, &file);
  return 0;
}
