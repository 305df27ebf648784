#include "control/fault.h"

#include <charconv>

#include "base/text.h"
#include "control/cnc.h"

namespace merker::cnc {
namespace {

using sinumerik::EpromFault;
using sinumerik::Surroundings;

struct Row {
  std::string_view subject, kind;
  void (*set)(Surroundings&, bool on);
};

void eprom(Surroundings& s, EpromFault fault, bool on) {
  s.basicProgram = on ? fault : EpromFault::None;
}

// clang-format off
constexpr Row kRows[] = {
    {"unit", "silent", [](Surroundings& s, bool on) { s.unit.answers = !on; }},            // 6138
    {"unit", "mains", [](Surroundings& s, bool on) { s.unit.mains = !on; }},               // 6138, NAU
    {"unit", "transmission", [](Surroundings& s, bool on) { s.unit.transmission = !on; }}, // 6139
    {"unit", "changed", [](Surroundings& s, bool on) { s.unit.changed = on; }},            // 6147
    {"unit", "temperature", [](Surroundings& s, bool on) { s.unit.overTemperature = on; }},// 6148
    {"jumpers", "wrong", [](Surroundings& s, bool on) { s.jumpersRight = !on; }},          // 6122
    {"memory", "gap", [](Surroundings& s, bool on) { s.memoryGap = on; }},                 // 6124
    {"memory", "program missing", [](Surroundings& s, bool on) { s.programMemoryFitted = !on; }},
    {"memory", "data missing", [](Surroundings& s, bool on) { s.dataMemoryFitted = !on; }},
    {"EPROM", "synchronisation", [](Surroundings& s, bool on) { eprom(s, EpromFault::Synchronisation, on); }},  // 6130
    {"EPROM", "block", [](Surroundings& s, bool on) { eprom(s, EpromFault::Block, on); }},                      // 6133
    {"EPROM", "checksum", [](Surroundings& s, bool on) { eprom(s, EpromFault::Checksum, on); }}};               // 6137
// clang-format on

constexpr std::string_view kCoupling = "coupling", kRemoved = "removed";

// "EB 4" or "AB 8" of the module's bytes.
bool contains(const sinumerik::Module& module, std::string_view subject) {
  const std::string_view area = subject.substr(0, 2);
  const bool input = equalsIgnoreCase(area, "EB") || equalsIgnoreCase(area, "IB");
  const bool output = equalsIgnoreCase(area, "AB") || equalsIgnoreCase(area, "QB");
  if ((!input && !output) || output != module.output) return false;
  const std::string_view digits = trim(subject.substr(2));
  unsigned byte = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte);
  const bool number = error == std::errc() && end == digits.data() + digits.size();
  return number && byte >= module.first && byte - module.first < module.bytes;
}

sinumerik::Module* findModule(Surroundings& around, std::string_view subject) {
  for (sinumerik::Module& module : around.modules)
    if (!module.name.empty() && equalsIgnoreCase(module.name, subject)) return &module;
  for (sinumerik::Module& module : around.modules)
    if (contains(module, subject)) return &module;
  return nullptr;
}

std::string title(const sinumerik::Module& module) {
  const std::string byte = (module.output ? "AB " : "EB ") + std::to_string(module.first);
  return "\"" + (module.name.empty() ? byte : module.name) + "\"";
}

std::string known(const Surroundings& around) {
  std::string list = "there are";
  for (const Row& row : kRows)
    list += (list.size() > 9 ? ", " : " ") + std::string(row.subject) + " " + std::string(row.kind);
  list += ", coupling interface, coupling memory";
  for (const sinumerik::Module& module : around.modules) list += ", " + title(module) + " removed";
  return list;
}

std::string setCoupling(Cnc& control, std::string_view kind, bool on) {
  nc::CouplingArea* area = control.couplingArea();
  if (area == nullptr) return "there is no coupled control ([coupling] in merker.toml)";
  const bool interface = equalsIgnoreCase(kind, "interface");
  if (!interface && !equalsIgnoreCase(kind, "memory"))
    return "there are coupling interface (message 1 of FB 190) and coupling memory (6151)";
  (interface ? area->faulty : area->silent) = on;
  return {};
}

}  // namespace

std::string setFault(Cnc& control, std::string_view subject, std::string_view kind, bool on) {
  Surroundings& around = control.plc().surroundings();
  if (equalsIgnoreCase(subject, kCoupling)) return setCoupling(control, kind, on);
  for (const Row& row : kRows) {
    if (!equalsIgnoreCase(row.subject, subject) || !equalsIgnoreCase(row.kind, kind)) continue;
    row.set(around, on);
    return {};
  }
  sinumerik::Module* module = findModule(around, subject);
  if (module == nullptr || !equalsIgnoreCase(kind, kRemoved)) return known(around);
  module->fitted = !on;
  return {};
}

}  // namespace merker::cnc
