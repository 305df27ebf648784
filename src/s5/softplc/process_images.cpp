#include "softplc/process_images.h"

#include "base/bcd.h"
#include "softplc/periphery_check.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint16_t kReading = 0x000E, kWriting = 0x000A;  // xxx2 of 6154 and 6158

const Module* missingModule(const std::vector<Module>& modules) {
  for (const Module& module : modules)
    if (!module.fitted && !module.distributed) return &module;
  return nullptr;
}

}  // namespace

void ProcessImages::clear() {
  machine_.inputs.fill(0);
  machine_.outputs.fill(0);
  machine_.periphery.outputs.fill(0);
}

std::optional<Trap> ProcessImages::read(const std::vector<Module>& modules) {
  mount(modules, machine_.periphery);
  if (const Module* module = missingModule(modules)) {
    const auto byte = static_cast<std::uint16_t>(toBcd(module->first, 4));
    return Trap{Alarm::NoAnswerTransfer, {0, module->output ? kWriting : kReading, byte}};
  }
  machine_.inputs = machine_.periphery.inputs;
  forces.inputs.apply(machine_.inputs);
  return std::nullopt;
}

void ProcessImages::copyPanel(const ControlPanel& panel) {
  for (unsigned i = 0; i < panel.bytes; ++i)
    if (panel.input + i < kImageBytes && panel.output + i < kImageBytes)
      machine_.outputs[panel.output + i] = machine_.inputs[panel.input + i];
}

void ProcessImages::write() {
  forces.outputs.apply(machine_.outputs);
  machine_.periphery.outputs = machine_.outputs;
}

}  // namespace merker::sinumerik
