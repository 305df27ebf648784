// Addresses: the slot's own (S7-HW-20 to -25) where none is given, then no overlap and no byte
// beyond the CPU's area (S7-HW-28, S7-CPU-11).
#include "io/addresses.h"

#include <algorithm>

namespace merker::io {
namespace {

constexpr std::uint32_t kSerialStart = 1023;  // as LADDR (PTP-SFBG-11)

std::uint32_t onBoardStart(const OnBoard& onBoard, std::uint32_t subslot) {
  switch (subslot) {
    case 1:
      return kSerialStart;
    case 2:
      return onBoard.digital;
    case 3:
      return onBoard.analog;
    case 4:
      return onBoard.counting;
    default:
      return onBoard.positions;
  }
}

std::uint32_t defaultStart(const Module& module, const CpuModel& model) {
  if (module.onBoard()) return onBoardStart(model.onBoard, module.subslot);
  return module.type->analogAddresses() ? analogStart(module.rack, module.slot)
                                        : digitalStart(module.rack, module.slot);
}

// One side of a module: inputs or outputs.
struct Stretch {
  const Module* module;
  std::uint32_t first, last;
  const Position* position;
};

std::vector<Stretch> stretches(const Configuration& configuration, bool outputs) {
  std::vector<Stretch> list;
  for (const Module& m : configuration.modules) {
    if (!outputs && m.inputStart)
      list.push_back({&m, *m.inputStart, m.inputEnd(), &m.inputPosition});
    if (outputs && m.outputStart)
      list.push_back({&m, *m.outputStart, m.outputEnd(), &m.outputPosition});
  }
  return list;
}

// Where to point: at the address if it was written, else at the module.
Position place(const Stretch& stretch) {
  return stretch.position->line != 0 ? *stretch.position : stretch.module->position;
}

std::string who(const Module& module) {
  return "slot " + module.slotText() + " (" + title(*module.type) + ")";
}

void checkOverlap(const Stretch& a, const Stretch& b, std::string_view area, Problems& problems) {
  if (a.first > b.last || b.first > a.last) return;
  // The problem stands where something can be changed: the later module, unless it is not
  // mentioned.
  const bool second = b.module->position.line != 0;
  const Stretch& one = second ? b : a;
  const Stretch& two = second ? a : b;
  problems.add(ProblemCode::P0733, place(one), area, one.first, one.last, who(*one.module), area,
               two.first, two.last, who(*two.module));
}

// Analog values are words, and words of a module lie at even addresses.
void checkEven(const Stretch& stretch, Problems& problems) {
  if (stretch.module->type->kind == ModuleKind::Analog && stretch.first % 2 != 0)
    problems.add(ProblemCode::P0750, place(stretch), stretch.first, who(*stretch.module));
}

void check(const Configuration& configuration, bool outputs, Problems& problems) {
  const std::string_view area = outputs ? "output bytes" : "input bytes";
  const std::uint32_t bytes = configuration.model->peripheralBytes;
  const auto list = stretches(configuration, outputs);
  for (auto one = list.begin(); one != list.end(); ++one) {
    checkEven(*one, problems);
    if (one->last >= bytes)
      problems.add(ProblemCode::P0734, place(*one), area, one->first, one->last, who(*one->module),
                   bytes - 1, configuration.model->name);
    for (auto other = list.begin(); other != one; ++other)
      checkOverlap(*other, *one, area, problems);
  }
}

}  // namespace

void assignAddresses(Configuration& configuration) {
  for (Module& module : configuration.modules) {
    std::uint32_t start = defaultStart(module, *configuration.model);
    // CNT-PIO-07: the counters have one address for both directions, unless two are given.
    if (module.type->kind == ModuleKind::Counting)
      start = module.inputStart.value_or(module.outputStart.value_or(start));
    if (module.type->hasInputs() && !module.inputStart) module.inputStart = start;
    if (module.type->hasOutputs() && !module.outputStart) module.outputStart = start;
  }
}

void checkAddresses(const Configuration& configuration, Problems& problems) {
  check(configuration, false, problems);
  check(configuration, true, problems);
}

}  // namespace merker::io
