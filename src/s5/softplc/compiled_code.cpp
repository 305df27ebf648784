#include "softplc/compiled_code.h"

namespace merker::sinumerik {

CompiledCode::CompiledCode(const Options& options, Machine& machine, const Environment& environment,
                           Recorder& recorder, Probes& probes)
    : options_(options),
      machine_(machine),
      environment_(environment),
      recorder_(recorder),
      probes_(probes) {}

void CompiledCode::translate() {
  if (options_.engine == nullptr || version_ == machine_.blocks.codeVersion()) return;
  version_ = machine_.blocks.codeVersion();
  std::vector<bool> apart = recorder_.watched(machine_.blocks);
  if (probes_.any()) probes_.addTo(apart, machine_.blocks);
  options_.engine->compile(machine_, environment_, apart);
}

// Code that writes code is the processor's, and so is every instruction that coverage counts.
std::uint64_t CompiledCode::run(Instant horizon) {
  Engine* const engine = options_.engine;
  if (engine == nullptr || options_.coverage || machine_.blocks.patched()) return 0;
  if (engine->payback.spend(1)) engine->on = true;
  if (!engine->on) return 0;
  translate();
  return engine->run(machine_, horizon);
}

}  // namespace merker::sinumerik
