// The process images between the modules and the program, and what holds bytes in them (S5-OB-16,
// -17).
#pragma once

#include <optional>
#include <vector>

#include "softplc/forces.h"
#include "softplc/machine.h"
#include "softplc/options.h"

namespace merker::sinumerik {

struct ImageForces {
  Forces<kImageBytes> inputs, outputs;
  Forces<kFlagBytes> flags;
  bool any() const { return inputs.any() || outputs.any() || flags.any(); }
  void clear() {
    inputs.clear();
    outputs.clear();
    flags.clear();
  }
};

class ProcessImages {
 public:
  explicit ProcessImages(Machine& machine) : machine_(machine) {}

  void clear();
  // The trap if a module that was there at start-up does not answer any more.
  std::optional<Trap> read(const std::vector<Module>& modules);
  void copyPanel(const ControlPanel& panel);  // inputs to outputs (S5-MD-06)
  void write();
  void forceFlags() { forces.flags.apply(machine_.flags); }

  ImageForces forces;

 private:
  Machine& machine_;
};

}  // namespace merker::sinumerik
