// What the steps of a scenario are bound to, once, before anything runs: so all problems come out
// together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/rack.h"
#include "plant/plants.h"
#include "scenario/term.h"

namespace merker::simulator {

struct Step;
namespace steps {
struct Station;
}

// One station of a project of several.
struct StationBinding {
  std::string name;
  Resolver resolver;  // also of the others, with their names in front
  const io::Configuration* hardware = nullptr;
  const plant::Configuration* plants = nullptr;
  std::vector<std::string> subnets{};  // it is a node of these
};

struct StepBinding {
  const Resolver& resolver;           // operands of the program
  const io::Configuration* hardware;  // null: there is no hardware configuration
  const plant::Configuration* plants;
  Problems& problems;
  const std::vector<StationBinding>* stations = nullptr;  // null: there is only this one
  std::size_t station = 0;                                // of these

  void bind(std::vector<Step>& steps) const;

 private:
  std::optional<std::size_t> find(const steps::Station& wanted) const;
  StepBinding of(std::size_t number) const;
};

}  // namespace merker::simulator
