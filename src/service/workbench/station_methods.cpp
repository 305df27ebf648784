// Several stations in one project (S7-MGR-13, S7-NETPRO-02 to -06): which of them is shown, what is
// done to all of them and to their lines, new ones.
#include <filesystem>

#include "project/files.h"
#include "scenario/duration.h"
#include "workbench/elsewhere.h"
#include "workbench/new_station.h"
#include "workbench/station_rows.h"
#include "workbench/subnet_change.h"

namespace merker::workbench {
namespace station_methods {
namespace {

Answer noLaboratory() {
  return refused(ProblemCode::P1308, "stations", "the project has one station only");
}

Answer list(const Call& call) {
  const Shared& shared = call.shared;
  if (!shared.lab) return Json{{"network", nullptr}};
  return Json{{"network", stationRows(*shared.lab, shared.stationName())}};
}

// The number of the station that the request names; a problem without one.
std::optional<std::size_t> stationOf(const Call& call, std::optional<Answer>& why) {
  const std::string name = call.fields.name("station");
  if (!call.fields.good())
    why = call.fields.problems();
  else if (!call.shared.lab)
    why = noLaboratory();
  else if (const auto found = call.shared.lab->find(name))
    return found;
  else
    why = refused(ProblemCode::P1316, "station", name, "");
  return std::nullopt;
}

Answer show(const Call& call) {
  std::optional<Answer> why;
  const auto number = stationOf(call, why);
  if (!number) return *why;
  call.shared.showStation(*number);
  return empty();
}

Answer watch(const Call& call) {
  call.browser.stations = call.fields.flag("on");
  call.browser.stationsSeen = nullptr;
  return call.fields.good() ? empty() : Answer(call.fields.problems());
}

Answer command(const Call& call) {
  const std::size_t wanted =
      call.fields.choice("command", {"run", "stop", "powerOn", "powerOff", "reset"});
  std::optional<Answer> why;
  const auto number = stationOf(call, why);
  if (!number) return *why;
  controller::Controller& plc = call.shared.lab->network->itself(*number);
  const bool off = !plc.powered() && wanted != 2;
  if (off) return refused(ProblemCode::P1308, call.fields.text("station"), "it is switched off");
  if (wanted == 0 && !plc.warmRestart())
    return refused(ProblemCode::P1308, call.fields.text("station"), "the CPU refuses the restart");
  if (wanted == 1) plc.stop();
  if (wanted == 2) plc.powerOn(true);
  if (wanted == 3) plc.powerOff();
  if (wanted == 4) plc.memoryReset();
  return empty();
}

// `station`: its plug alone.
Answer fault(const Call& call) {
  const std::string name = call.fields.name("subnet");
  const std::string station = call.fields.text("station", "");
  const std::size_t what = call.fields.choice("fault", {"break", "mend", "delay"});
  const auto delay = call.fields.integer("delay", 0, 10'000'000'000, 0);
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  network::Network& network = *call.shared.lab->network;
  network::Subnet* const subnet = network.subnet(name);
  if (subnet == nullptr) return refused(ProblemCode::P1316, "subnet", name, "");
  if (what == 2) return subnet->delay(Duration{delay}), empty();
  if (station.empty()) return what == 0 ? subnet->interrupt() : subnet->mend(), empty();
  const auto number = network.find(station);
  const auto address = number ? network.addressOf(*number, *subnet) : std::nullopt;
  if (!address) return refused(ProblemCode::P1316, "station", station, "");
  what == 0 ? subnet->interrupt(*address) : subnet->mend(*address);
  return empty();
}

// A project that is ready to be shown.
struct Ready {
  std::optional<Answer> refused;
  std::shared_ptr<Laboratory> lab;
  Listing seen;
};

Ready ready(const std::string& path, std::optional<station::Engine> engine) {
  Ready result;
  Problems problems;
  project::Project project = project::load(path, {});
  if (!project.network) {
    result.refused = noLaboratory();
    return result;
  }
  const ProjectFolder folder(project.folder);
  result.lab = makeLaboratory(std::move(project), engine, problems);
  if (!result.lab) result.refused = written(problems, folder);
  return result;
}

// `change` writes files, in the thread of the worker; then all of the project is opened anew.
// It gives the folder of the project, or says why not.
Answer reopened(const Call& call, std::function<Result<std::string>(const Aside&)> change,
                const std::string& station) {
  return elsewhere<Ready>(
      call, call.shared.work,
      [change = std::move(change), engine = call.shared.engine(), station](const Aside& aside) {
        const auto path = change(aside);
        if (!path) {
          Ready result;
          result.refused = one(path.error());
          return result;
        }
        Ready result = ready(*path, engine);
        if (!result.lab) return result;
        const std::size_t shown = result.lab->find(station).value_or(0);
        result.seen = folderOf(result.lab->plcs[shown]->build().project).list();
        return result;
      },
      [station](const Call& now, Ready& ready) -> Answer {
        if (ready.refused) return std::move(*ready.refused);
        const std::size_t shown = ready.lab->find(station).value_or(0);
        const std::string path = ready.lab->path;
        now.shared.show(std::move(ready.lab), shown, now.shared.example, std::move(ready.seen));
        now.shared.remember(path);
        return empty();
      });
}

Answer reload(const Call& call) {
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call, [path = call.shared.lab->path](const Aside&) -> Result<std::string> { return path; },
      call.shared.stationName());
}

// The wizard: a station from a template, at a subnet.
Answer add(const Call& call) {
  NewStation wanted;
  wanted.name = call.fields.name("name", 32);
  wanted.model = call.fields.text("model", std::string(defaultCpuModel().keyword));
  wanted.subnet = call.fields.text("subnet", "");
  wanted.address = static_cast<std::uint32_t>(call.fields.integer("address", 2, 126, 2));
  wanted.form = call.fields.text("template", "empty");
  wanted.mnemonics =
      static_cast<Mnemonics>(call.fields.choice("mnemonics", {"german", "international"}, 0));
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call,
      [wanted, path = call.shared.lab->path](const Aside&) { return addStation(path, wanted); },
      wanted.name);
}

Answer connect(const Call& call) {
  NewCircle wanted;
  wanted.from = call.fields.name("from");
  wanted.to = call.fields.texts("to", 15);
  wanted.rate = static_cast<std::uint32_t>(call.fields.integer("rate", 1, 255, 8));
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call,
      [wanted, path = call.shared.lab->path](const Aside&) { return addCircle(path, wanted); },
      call.shared.stationName());
}

Answer link(const Call& call) {
  NewLink wanted;
  wanted.local = call.fields.name("local", 32);
  wanted.partner = call.fields.name("partner", 32);
  wanted.subnet = call.fields.text("subnet", "");
  wanted.both = call.fields.flag("both", false);
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call, [wanted, path = call.shared.lab->path](const Aside&) { return addLink(path, wanted); },
      call.shared.stationName());
}

// S7-NETPRO-03, -04, -06
Answer attach(const Call& call) {
  NodeChange wanted;
  wanted.subnet = call.fields.name("subnet");
  wanted.station = call.fields.name("station", 32);
  wanted.address = call.fields.text("address", "");
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call,
      [wanted, path = call.shared.lab->path](const Aside&) { return changeNode(path, wanted); },
      call.shared.stationName());
}

Answer properties(const Call& call) {
  constexpr const char* kKinds[] = {"mpi", "ethernet", "profibus"};
  SubnetChange wanted;
  wanted.name = call.fields.name("subnet", 32);
  if (call.fields.has("kind"))
    wanted.kind = kKinds[call.fields.choice("kind", {"mpi", "ethernet", "profibus"})];
  wanted.master = call.fields.text("master", "");
  wanted.baud = call.fields.text("baud", "");
  wanted.highest = static_cast<std::uint32_t>(call.fields.integer("highest", 0, 126, 0));
  wanted.remove = call.fields.flag("remove", false);
  if (!call.fields.good()) return call.fields.problems();
  if (!call.shared.lab) return noLaboratory();
  return reopened(
      call,
      [wanted, path = call.shared.lab->path](const Aside&) { return changeSubnet(path, wanted); },
      call.shared.stationName());
}

// A new project whose first station is a copy of the one that is open.
Answer make(const Call& call) {
  const std::string name = call.fields.name("name"), station = call.fields.name("station", 32);
  if (!call.fields.good()) return call.fields.problems();
  if (call.shared.lab)
    return refused(ProblemCode::P1308, "stations", "the project has several stations already");
  const std::string from = call.plc().build().project.folder;
  const std::uint32_t address = call.plc().build().project.mpiAddress;
  return reopened(
      call,
      [workspace = call.shared.workspace, name, station, from, address](const Aside&) {
        return makeNetwork(workspace, name, station, from, address);
      },
      station);
}

constexpr Method kMethods[] = {
    {"stations.list", Needs::Nothing, list},
    {"stations.show", Needs::Nothing, show},
    {"stations.watch", Needs::Nothing, watch},
    {"stations.command", Needs::Nothing, command},
    {"stations.fault", Needs::Nothing, fault},
    {"stations.reload", Needs::Nothing, reload, Kind::Compiles},
    {"stations.add", Needs::Nothing, add, Kind::Compiles},
    {"stations.connect", Needs::Nothing, connect, Kind::Compiles},
    {"stations.link", Needs::Nothing, link, Kind::Compiles},
    {"stations.node", Needs::Nothing, attach, Kind::Compiles},
    {"stations.subnet", Needs::Nothing, properties, Kind::Compiles},
    {"stations.make", Needs::Plc, make, Kind::Compiles},
};

}  // namespace
}  // namespace station_methods

std::span<const Method> stationMethods() { return station_methods::kMethods; }

}  // namespace merker::workbench
