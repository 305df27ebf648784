#include "workbench/subnet_change.h"

#include "project/subnet_edit.h"
#include "workbench/json.h"
#include "workbench/network_file.h"

namespace merker::workbench {
namespace {

Problem unknownSubnet(const std::string& name) {
  return makeProblem(ProblemCode::P1316, nowhere(), "subnet", name, "");
}

Result<std::string> stored(const NetworkFile& file, const std::string& text,
                           const std::string& path) {
  if (auto problem = file.freshError(text)) return *problem;
  if (auto problem = file.write(text)) return *problem;
  return path;
}

// A PROFIBUS subnet has its DP master and at least one slave (S7-NET-10): an ET 200M, without
// modules so far.
std::string withNewSubnet(const NetworkFile& file, const SubnetChange& wanted) {
  project::SettingsEdit edit = file.edit();
  edit.addTable(
      "subnet",
      {{"name", tomlText(wanted.name)}, {"kind", tomlText(wanted.kind)}, {"nodes", "[]"}});
  if (wanted.kind != "profibus") return edit.text();
  edit.addTable(
      "slave",
      {{"subnet", tomlText(wanted.name)}, {"address", "3"}, {"type", tomlText("ET 200M")}});
  project::SubnetEdit nodes(edit.text());
  nodes.setNode(wanted.name, wanted.master, "2");
  return nodes.text();
}

// Numbers and points: no text that would mean something else in the file.
std::optional<Problem> wrongAddress(const std::string& text) {
  if (text.find_first_not_of("0123456789.") == std::string::npos) return std::nullopt;
  return makeProblem(ProblemCode::P1305, nowhere(), "address",
                     "a number like 3, on Ethernet an IP address like 192.168.0.3");
}

}  // namespace

Result<std::string> changeNode(const std::string& path, const NodeChange& wanted) {
  if (auto problem = wrongAddress(wanted.address)) return *problem;
  const NetworkFile file(path);
  if (auto problem = file.problem()) return *problem;
  project::SubnetEdit edit(file.text());
  const std::string kind = edit.kindOf(wanted.subnet);
  if (kind.empty()) return unknownSubnet(wanted.subnet);
  const project::Project before = file.with(file.text());
  if (!before.network || !findStation(*before.network, wanted.station))
    return makeProblem(ProblemCode::P1316, nowhere(), "station", wanted.station, "");
  // A station has one interface of a kind: it leaves the subnet where that was.
  if (!wanted.address.empty())
    for (const std::string& other : edit.subnetsOf(wanted.station, kind))
      if (other != wanted.subnet) edit.setNode(other, wanted.station, "");
  edit.setNode(wanted.subnet, wanted.station, wanted.address);
  return stored(file, edit.text(), path);
}

Result<std::string> changeSubnet(const std::string& path, const SubnetChange& wanted) {
  const NetworkFile file(path);
  if (auto problem = file.problem()) return *problem;
  const bool there = !project::SubnetEdit(file.text()).kindOf(wanted.name).empty();
  if (!there && wanted.kind.empty()) return unknownSubnet(wanted.name);
  project::SubnetEdit edit(there ? file.text() : withNewSubnet(file, wanted));
  if (!wanted.baud.empty()) edit.set(wanted.name, "baud", tomlText(wanted.baud));
  if (wanted.highest != 0) edit.set(wanted.name, "highest", std::to_string(wanted.highest));
  if (wanted.remove) edit.remove(wanted.name);
  return stored(file, edit.text(), path);
}

}  // namespace merker::workbench
