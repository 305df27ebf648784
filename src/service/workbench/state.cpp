#include <algorithm>
#include <array>

#include "cpu/led_panel.h"
#include "cpu/switch_panel.h"
#include "plc/machine_code.h"
#include "workbench/neighbours.h"
#include "workbench/shared.h"

namespace merker::workbench {
namespace {

constexpr std::string_view kModes[] = {"STOP", "STARTUP", "RUN", "HALT"};
constexpr std::string_view kSwitch[] = {"RUN-P", "RUN", "STOP", "MRES"};
constexpr std::string_view kLights[] = {"off", "on", "slow", "fast"};
constexpr std::string_view kPaces[] = {"real", "fast", "pause"};

template <typename E>
std::string_view word(const auto& names, E value) {
  return names[static_cast<std::size_t>(value)];
}

Json lampRows(const cpu::Leds& leds) {
  const auto text = [](cpu::Light light) { return word(kLights, light); };
  return {{"SF", text(leds.sf)},     {"BF", text(leds.bf)},   {"DC5V", text(leds.dc5v)},
          {"FRCE", text(leds.frce)}, {"RUN", text(leds.run)}, {"STOP", text(leds.stop)}};
}

// A SINUMERIK shows its PLC's state on the screen; here it looks like the others.
cpu::Leds ledsOf(const Plc& plc) {
  if (const auto* panel = controller::capability<cpu::LedPanel>(plc.controller()))
    return panel->leds();
  const auto light = [](bool on) { return on ? cpu::Light::On : cpu::Light::Off; };
  const controller::Controller& c = plc.controller();
  const bool halted = c.mode() == controller::Mode::Halt;
  const bool stopped = c.mode() == controller::Mode::Stop;
  cpu::Leds leds;
  leds.sf = light(c.stoppedByFault());
  leds.dc5v = light(c.powered());
  leds.frce = light(!plc.monitor().forces().empty());
  leds.run = halted ? cpu::Light::Slow : light(c.powered() && !stopped);
  leds.stop = light(c.powered() && (stopped || halted));
  return leds;
}

Json forces(const Plc& plc) {
  Json list = Json::array();
  for (const monitor::Forced& one : plc.monitor().forces())
    list.push_back(
        {{"operand", one.operand.text},
         {"value", monitor::show(one.operand, one.value, monitor::DisplayFormat::Automatic)}});
  return list;
}

Json breakpoint(Shared& shared) {
  Plc& plc = *shared.plc;
  if (plc.controller().mode() != controller::Mode::Halt) return nullptr;
  const auto place = plc.monitor().debugger().position();
  if (!place) return nullptr;
  Json at = {{"file", shared.folder.relative(place->file)},
             {"line", place->line},
             {"block", toString(place->block)}};
  at["why"] = "HALT at " + monitor::toString(*place);
  return at;
}

std::string_view switchOf(const controller::Controller& plc) {
  if (const auto* panel = controller::capability<cpu::SwitchPanel>(plc))
    return word(kSwitch, panel->switchPosition());
  return plc.mode() == controller::Mode::Stop ? "STOP" : "RUN";
}

void addMachine(Json& json, const Plc& plc) {
  const monitor::Monitor& monitor = plc.monitor();
  const auto* code = controller::capability<controller::MachineCode>(plc.controller());
  const auto cycle = monitor.cycleTimes();
  json["switch"] = switchOf(plc.controller());
  json["clock"] = monitor.clock();
  json["cycle"] =
      !cycle ? Json(nullptr)
             : Json{{"last", cycle->last}, {"min", cycle->shortest}, {"max", cycle->longest}};
  json["engine"] = code != nullptr && code->compiled() ? "jit" : "interpreter";
  json["diagnostics"] = monitor.diagnosticsAdded();
  json["timersByHand"] = monitor.timersHeld();
}

Json recording(const Recorder& recorder) {
  if (!recorder.on()) return nullptr;
  return {{"since", recorder.begin().ns},
          {"actions", recorder.actions().size()},
          {"full", recorder.full()}};
}

// What the page offers of this machine.
Json abilities(const Plc& plc) {
  Json list = Json::array();
  for (const monitor::FeatureName& one : monitor::features())
    if (plc.can(one.feature)) list.push_back(one.name);
  return list;
}

// Which one this is, and how many are in use.
Json plcs(const Shared& shared) {
  return {{"here", shared.plcNumber},
          {"count", shared.neighbours == nullptr ? 1 : shared.neighbours->count()}};
}

// Whether there is an interface X27 in operation.
bool hasSerial(const Plc& plc) {
  const io::Rack* rack = plc.rack();
  return rack != nullptr &&
         std::ranges::any_of(rack->configuration().modules, [](const io::Module& one) {
           return one.type->kind == ModuleKind::PointToPoint && one.parameters.serial != nullptr;
         });
}

Json project(const Shared& shared) {
  const project::Project& project = shared.plc->build().project;
  return {{"name", project.name},
          {"folder", project.path},
          {"mpiAddress", project.mpiAddress},
          {"can", abilities(*shared.plc)},
          {"family", shared.plc->build().isListing() ? "S5" : "S7"},
          {"model", shared.plc->controller().modelName()},
          {"example", shared.example},
          {"serial", hasSerial(*shared.plc)},
          {"empty", shared.plc->program() != nullptr && shared.plc->program()->empty()},
          {"changed", shared.files.changed()},
          {"station", shared.stationName()},
          {"network", shared.lab ? shared.lab->path : ""}};
}

}  // namespace

std::string_view modeOf(const Plc& plc) { return word(kModes, plc.controller().mode()); }
Json lampsOf(const Plc& plc) { return lampRows(ledsOf(plc)); }

Json state(Shared& shared) {
  const Pace& pace = shared.pacer.pace();
  Json json = {{"event", "state"},
               {"project", nullptr},
               {"pace", {{"mode", word(kPaces, pace.mode)}, {"factor", pace.factor}}},
               {"reached", shared.pacer.reached()},
               {"browsers", shared.browsers},
               {"plcs", plcs(shared)},
               {"program", shared.programRevision},
               {"files", shared.filesRevision}};
  if (!shared.plc) return json;
  Plc& plc = *shared.plc;
  const controller::Controller& c = plc.controller();
  json["project"] = project(shared);
  json["mode"] = modeOf(plc);
  json["powered"] = c.powered();
  json["leds"] = lampsOf(plc);
  json["stopReason"] = shared.folder.withoutFolder(c.stopReason());
  json["time"] = c.now().ns;
  json["cycles"] = c.cycles();
  json["forces"] = forces(plc);
  json["breakpoint"] = breakpoint(shared);
  json["breakpoints"] = shared.breakpoints;
  json["recording"] = recording(shared.recorder);
  json["playback"] = shared.player.describe();
  addMachine(json, plc);
  return json;
}

Json difference(const Json& before, const Json& now) {
  Json changed = Json::object();
  for (const auto& [key, value] : now.items()) {
    const auto old = before.find(key);
    if (old == before.end() || *old != value) changed[key] = value;
  }
  return changed;
}

}  // namespace merker::workbench
