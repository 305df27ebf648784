#include "cpu/leds.h"

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

constexpr std::int64_t kSlowHalf = 1'000'000'000, kFastHalf = 250'000'000;  // ns

Light on(bool condition) { return condition ? Light::On : Light::Off; }

Light runLight(Mode mode) {
  if (mode == Mode::Startup) return Light::Fast;
  if (mode == Mode::Halt) return Light::Slow;
  return on(mode == Mode::Run);
}

}  // namespace

bool shines(Light light, Instant now) {
  if (light == Light::Slow) return now.ns / kSlowHalf % 2 != 0;
  if (light == Light::Fast) return now.ns / kFastHalf % 2 != 0;
  return light == Light::On;
}

Light Cpu::stopLight() const {
  switch (switch_.sequence(machine_.clock)) {
    case ModeSwitch::Sequence::Reset:
      return Light::Fast;
    case ModeSwitch::Sequence::Pressed:
      return Light::Slow;
    case ModeSwitch::Sequence::Armed:
      return Light::On;
    case ModeSwitch::Sequence::None:
      break;
  }
  if (resetRequested_) return Light::Slow;
  return on(mode() != Mode::Run);  // also in STARTUP and HALT
}

Leds Cpu::leds() const {
  if (!powered_) return {};
  return {.sf = on(state_.stoppedByFault() || faults_.any()),
          .bf = on(faults_.racks()),
          .batf = on(faults_.battery),
          .dc5v = Light::On,
          .frce = on(!forces_.empty()),
          .run = runLight(mode()),
          .stop = stopLight()};
}

}  // namespace merker::cpu
