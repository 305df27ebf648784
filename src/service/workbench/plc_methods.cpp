// Mode switch, power, start and stop, events by hand, pace of time.
#include <array>

#include "address/constant.h"
#include "base/bytes.h"
#include "cpu/events_by_hand.h"
#include "cpu/real_time_clock.h"
#include "cpu/switch_panel.h"
#include "cpu/trigger.h"
#include "plc/machine_code.h"
#include "workbench/translated.h"

namespace merker::workbench {
namespace plc_methods {
namespace {

using monitor::Feature;

using cpu::SwitchPosition;

Answer notStarted(const controller::Controller& plc) {
  const std::string reason = plc.stopReason();
  return refused(ProblemCode::P1308, "the CPU does not start",
                 reason.empty() ? std::string("it is not possible now") : reason);
}

// A machine without such a switch: RUN and STOP are keys of the programmer.
Answer pressKey(controller::Controller& plc, SwitchPosition key) {
  if (key != SwitchPosition::Run && key != SwitchPosition::Stop)
    return refused(ProblemCode::P1307, plc.modelName(), "mode switch, only RUN and STOP");
  if (!plc.powered()) return refused(ProblemCode::P1308, plc.modelName(), "it is switched off");
  if (key == SwitchPosition::Stop) return plc.stop(), empty();
  const bool runs = plc.mode() != controller::Mode::Stop;
  return runs || plc.start() ? empty() : notStarted(plc);
}

Answer turnSwitch(const Call& call) {
  const std::size_t position = call.fields.choice("position", {"RUN-P", "RUN", "STOP", "MRES"});
  if (!call.fields.good()) return call.fields.problems();
  const auto to = static_cast<SwitchPosition>(position);
  auto* panel = controller::capability<cpu::SwitchPanel>(call.plc().controller());
  if (panel == nullptr) return pressKey(call.plc().controller(), to);
  const bool reset = to == SwitchPosition::Mres;
  if (reset && !call.plc().controller().powered())
    return refused(ProblemCode::P1308, "MRES", "the CPU is switched off");
  panel->setSwitch(reset ? SwitchPosition::Stop : to);
  if (reset) call.plc().controller().memoryReset();
  return empty();
}

Answer power(const Call& call) {
  const bool on = call.fields.flag("on"), battery = call.fields.flag("battery", true);
  if (!call.fields.good()) return call.fields.problems();
  controller::Controller& plc = call.plc().controller();
  if (on == plc.powered()) return empty();
  on ? plc.powerOn(battery) : plc.powerOff();
  return empty();
}

Answer start(const Call& call) {
  const bool cold = call.fields.choice("kind", {"warm", "cold"}, 0) == 1;
  if (!call.fields.good()) return call.fields.problems();
  controller::Controller& plc = call.plc().controller();
  if (cold && !plc.hasColdRestart())
    return refused(ProblemCode::P1307, plc.modelName(), "cold restart");
  call.monitor().stop();
  return (cold ? plc.coldRestart() : plc.start()) ? empty() : notStarted(plc);
}

Answer stop(const Call& call) {
  call.monitor().stop();
  return empty();
}

Answer reset(const Call& call) {
  if (call.plc().controller().mode() != controller::Mode::Stop)
    return refused(ProblemCode::P1308, "memory reset", "possible in STOP only");
  call.plc().controller().memoryReset();
  return empty();
}

Answer trigger(const Call& call) {
  const auto ob = call.fields.integer("ob", 1, 255);
  cpu::Trigger event;
  event.address = static_cast<std::uint16_t>(call.fields.integer("address", 0, 65535, 0));
  event.going = call.fields.flag("going", false);
  if (!call.fields.good()) return call.fields.problems();
  if (!cpu::canTrigger(static_cast<std::uint32_t>(ob)))
    return refused(ProblemCode::P1308, fmt::format("OB {}", ob),
                   "no event for it can be triggered manually");
  event.ob = static_cast<std::uint8_t>(ob);
  controller::capability<cpu::EventsByHand>(call.plc().controller())->trigger(event);
  return empty();
}

// "2005-09-01 08:00:00.000" as milliseconds since 1990-01-01 (S7-TYPES-18).
std::optional<std::int64_t> clockTime(std::string text) {
  if (const auto gap = text.find(' '); gap != std::string::npos) text[gap] = '-';
  const auto bcd = parseDateAndTime("DT#" + text, nowhere());
  if (!bcd) return {};
  std::array<std::uint8_t, 8> bytes{};
  storeDWord(bytes.data(), static_cast<std::uint32_t>(*bcd >> 32));
  storeDWord(bytes.data() + 4, static_cast<std::uint32_t>(*bcd));
  return cpu::fromDateAndTime(bytes.data());
}

Answer setClock(const Call& call) {
  const std::string time = call.fields.text("time");
  if (!call.fields.good()) return call.fields.problems();
  const auto milliseconds = clockTime(time);
  if (!milliseconds)
    return refused(ProblemCode::P1305, "time",
                   "a date and a time of the years 1990 to 2089, like 2005-09-01 08:00:00");
  call.monitor().setClock(*milliseconds);
  return empty();
}

std::optional<Problems> engineStays(const Call& call) {
  if (call.plc().controller().mode() == controller::Mode::Stop) return std::nullopt;
  return refused(ProblemCode::P1308, "the engine", "it can be changed in STOP only");
}

Answer noCompiler() {
  return refused(ProblemCode::P1307, "this processor", "jit; use interpreter");
}

// A machine that translates its own program when it runs next.
Answer useEngine(controller::Controller& plc, station::Engine wanted) {
  const bool compiled = wanted == station::Engine::Compiled;
  auto* code = controller::capability<controller::MachineCode>(plc);
  return code->setCompiled(compiled) || !compiled ? empty() : noCompiler();
}

Answer engine(const Call& call) {
  const auto wanted =
      static_cast<station::Engine>(call.fields.choice("engine", {"interpreter", "jit"}));
  if (!call.fields.good()) return call.fields.problems();
  if (auto why = engineStays(call)) return *why;
  if (call.plc().blockCpu() == nullptr) return useEngine(call.plc().controller(), wanted);
  if (call.blockCpu().engine() == wanted) return empty();
  return translatedFor(call, wanted,
                       [wanted](const Call& now, const station::Translations& made) -> Answer {
                         if (auto why = engineStays(now)) return *why;
                         if (now.blockCpu().setEngine(wanted, made)) return empty();
                         return noCompiler();
                       });
}

Answer pace(const Call& call) {
  const auto mode = static_cast<PaceMode>(call.fields.choice("mode", {"real", "fast", "pause"}));
  const double factor = call.fields.number("factor", 0.1, 100, call.shared.pacer.pace().factor);
  if (!call.fields.good()) return call.fields.problems();
  call.shared.pacer.set({mode, factor});
  return empty();
}

Answer step(const Call& call) {
  const auto cycles = call.fields.integer("cycles", 1, 1'000'000, 1);
  if (!call.fields.good()) return call.fields.problems();
  if (call.shared.pacer.pace().mode != PaceMode::Pause)
    return refused(ProblemCode::P1308, "single cycles", "possible while time is paused");
  call.shared.pacer.step(static_cast<std::uint64_t>(cycles));
  return empty();
}

constexpr Method kMethods[] = {
    {"cpu.switch", Needs::Plc, turnSwitch, Kind::Action},
    {"cpu.power", Needs::Plc, power, Kind::Action},
    {"cpu.start", Needs::PlcOn, start, Kind::Action},
    {"cpu.stop", Needs::PlcOn, stop, Kind::Action},
    {"cpu.reset", Needs::PlcOn, reset, Kind::Action},
    {"cpu.trigger", Needs::ableOn(Feature::Interrupts), trigger, Kind::Action},
    {"cpu.setClock", Needs::ableOn(Feature::Clock), setClock, Kind::Action},
    {"cpu.engine", Needs::able(Feature::Engine), engine},
    {"time.pace", Needs::Nothing, pace},
    {"time.step", Needs::Plc, step},
};

}  // namespace
}  // namespace plc_methods

std::span<const Method> plcMethods() { return plc_methods::kMethods; }

}  // namespace merker::workbench
