#include "softplc/periphery_check.h"

#include "base/bcd.h"

namespace merker::sinumerik {
namespace {

Trap at(Alarm alarm, unsigned byte) {
  return {alarm, {0, 0, static_cast<std::uint16_t>(toBcd(byte, 4))}};
}

bool inside(const Module& module, unsigned byte) {
  return byte >= module.first && byte - module.first < module.bytes;
}

std::optional<Trap> overlap(const Module& a, const Module& b) {
  if (a.output != b.output) return std::nullopt;
  const unsigned byte = a.first > b.first ? a.first : b.first;
  if (!inside(a, byte) || !inside(b, byte)) return std::nullopt;
  return at(a.output ? Alarm::OutputsTwice : Alarm::InputsTwice, byte);
}

std::optional<Trap> checkOne(const Module& module) {
  const bool within = module.first < kPeripheryBytes && module.bytes > 0 &&
                      module.bytes <= kPeripheryBytes - module.first;
  if (!within) return at(Alarm::PeripheryAssignment, module.first);
  if (!module.fitted) return at(Alarm::MissingConverter, module.first);
  return std::nullopt;
}

}  // namespace

std::vector<Module> standardModules() {
  return {{.output = false, .first = 0, .bytes = kPeripheryBytes},
          {.output = true, .first = 0, .bytes = kPeripheryBytes}};
}

std::optional<Trap> checkModules(const std::vector<Module>& modules) {
  for (std::size_t i = 0; i < modules.size(); ++i) {
    if (auto fault = checkOne(modules[i])) return fault;
    for (std::size_t earlier = 0; earlier < i; ++earlier)
      if (auto fault = overlap(modules[earlier], modules[i])) return fault;
  }
  return std::nullopt;
}

void mount(const std::vector<Module>& modules, Periphery& periphery) {
  periphery.inputPresent.fill(false);
  periphery.outputPresent.fill(false);
  for (const Module& module : modules) {
    if (checkOne(module)) continue;
    auto& present = module.output ? periphery.outputPresent : periphery.inputPresent;
    for (unsigned i = 0; i < module.bytes; ++i) present[module.first + i] = true;
  }
}

bool isDistributed(const std::vector<Module>& modules, unsigned inputByte) {
  for (const Module& module : modules)
    if (!module.output && module.distributed && inside(module, inputByte)) return true;
  return false;
}

}  // namespace merker::sinumerik
