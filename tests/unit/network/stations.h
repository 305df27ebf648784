// Stations made of texts, for tests of networks.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "compilation/build.h"
#include "network/network.h"

namespace merker::network::test {

// `lines`: the statements of OB 1; `more`: other blocks; `cpu`: its model, else the usual one;
// `cycle`: the shortest one in milliseconds, for tests of seconds.
inline std::unique_ptr<controller::Controller> station(const std::string& lines,
                                                       const std::string& more = {},
                                                       const std::string& cpu = {},
                                                       std::uint32_t cycle = 0) {
  const std::string text =
      more + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + lines + "\nEND_ORGANIZATION_BLOCK\n";
  auto build = compilation::build(project::load("a.awl", cpu, {{"a.awl", text}}), false);
  for (const Problem& problem : build.problems.list())
    ADD_FAILURE() << problem.message << " line " << problem.position.line;
  build.project.parameters.minimumCycle = cycle;
  return build.controller();
}

inline std::unique_ptr<controller::Controller> control() {
  const std::string text = "OB 1\n L MW 10\n L KF +1\n +F\n T MW 10\n BE\n";
  return compilation::build(project::load("a.s5", {}, {{"a.s5", text}}), false).controller();
}

inline address::Reference flagWord(unsigned byte) {
  return {.text = "MW", .operand = address::memory(Area::Flag, Width::Word, 8 * byte)};
}

inline std::uint32_t word(Network& network, std::size_t i, unsigned byte) {
  return network.itself(i).read(flagWord(byte)).value_or(0xFFFFFFFF);
}

inline void start(Network& network) {
  for (std::size_t i = 0; i < network.size(); ++i) {
    network.itself(i).memoryReset();
    ASSERT_TRUE(network.itself(i).start());
  }
}

}  // namespace merker::network::test
