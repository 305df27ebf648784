#include "project/settings.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "base/bcd.h"
#include "project/parse.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::int64_t kMillisecondsPerDay = 24 * 3600 * 1000;
constexpr std::string_view kPatterns =
    "a list of file names or patterns: [\"*.awl\", \"lib/**/*.awl\"]";

std::optional<std::vector<Pattern>> patterns(const Table& table, std::string_view key) {
  const auto texts = table.texts(key, kPatterns);
  if (!texts) return std::nullopt;
  std::vector<Pattern> list;
  for (const Table::Text& text : *texts) list.push_back({text.text, text.position});
  return list;
}

void readProject(const Table& table, Settings& settings) {
  table.allow({"name"});
  if (auto name = table.text("name", "a text")) settings.name = *name;
}

void readProgram(const Table& table, Settings& settings) {
  table.allow({"sources", "symbols", "mnemonics", "libraries"});
  settings.sources = patterns(table, "sources");
  settings.symbols = patterns(table, "symbols");
  if (const auto which = table.choice("mnemonics", {"german", "english"}))
    settings.mnemonics = static_cast<Mnemonics>(*which);
}

// Of [cpu]; nothing if it names none, or one that does not exist.
std::optional<Model> readModel(const Table& root) {
  const auto cpu = root.table("cpu");
  const auto name = cpu ? cpu->text("model", "the name of a CPU") : std::nullopt;
  if (!name) return std::nullopt;
  const auto model = findModel(*name);
  if (!model) cpu->problems().add(ProblemCode::P0705, cpu->at("model"), *name, modelNames());
  return model;
}

// Two BCD digits of a DATE_AND_TIME, counted from its first byte.
unsigned digits(std::uint64_t bcd, int byte) {
  const auto value = static_cast<std::uint32_t>(bcd >> (8 * (7 - byte)) & 0xFF);
  return fromBcd(value, 2).value_or(0);
}

std::int64_t millisecondsSince1990(std::uint64_t bcd) {
  const int year = static_cast<int>(digits(bcd, 0));
  const auto days =
      daysSince1990(year < 90 ? 2000 + year : 1900 + year, static_cast<int>(digits(bcd, 1)),
                    static_cast<int>(digits(bcd, 2)));
  const std::int64_t seconds = (digits(bcd, 3) * 60LL + digits(bcd, 4)) * 60 + digits(bcd, 5);
  const std::int64_t ms = digits(bcd, 6) * 10LL + (bcd >> 4 & 0xF);
  return days.value_or(0) * kMillisecondsPerDay + seconds * 1000 + ms;
}

void readCpu(const Table& table, Settings& settings) {
  settings.parameters = CpuParameters::of(*settings.model);
  if (const auto clock = readDateAndTime(table, "clock")) settings.startOfClock = *clock;
  settings.mpiAddress =
      table.number("mpi_address", kCpuMpiAddress, kHighestMpiAddress).value_or(settings.mpiAddress);
  readCpuParameters(table, *settings.model, settings.parameters);
}

// [hardware] and the modules. Modules with problems are left out. Plants are wired to terminals: a
// project that has some has hardware.
void readHardware(const Table& root, Settings& settings) {
  const auto hardware = root.table("hardware");
  if (hardware) {
    hardware->allow({"check_addresses", "mounting"});
    if (const auto check =
            hardware->choice("check_addresses", {"standard", "off", "warning", "error"}))
      settings.addressCheck = static_cast<AddressCheck>(*check);
    if (const auto way = hardware->choice("mounting", {"horizontal", "vertical"}))
      settings.vertical = *way == 1;
  }
  if (!root.has("hardware") && !root.has("module") && !root.has("plant") && !root.has("slave") &&
      !root.has("subnet"))
    return;
  std::vector<io::Module> modules;
  for (const Table& table : root.tables("module"))
    if (auto module = readModule(table, *settings.model)) modules.push_back(std::move(*module));
  settings.hardware = io::configure(std::move(modules), *settings.model, root.problems());
  for (const io::Module& module : settings.hardware->modules)
    if (module.web) settings.communication.web.push_back(*module.web);
  checkAxis(root, *settings.hardware);
  for (const DpSubnet& subnet : readDpSubnets(root, nullptr))
    plugSlaves(subnet, *settings.model, settings.hardware, root.problems());
}

void choose(Settings& settings, const Model& model) {
  if (model.simatic != nullptr) settings.model = model.simatic;
  if (model.sinumerik != nullptr) settings.control.emplace().model = model.sinumerik;
}

void readStation(const Table& root, Settings& settings) {
  root.allow({"project", "program", "cpu", "hardware", "module", "plant", "serial", "station",
              "communication", "connection", "subnet", "slave"});
  if (const auto table = root.table("cpu")) readCpu(*table, settings);
  readCommunicationProtection(root, settings.parameters);
  readConfigured(root, settings.communication);
  readHardware(root, settings);
  requireCp(root, settings);
  requireItCp(root, settings);
  settings.libraries = readLibraries(root, settings);
  if (settings.hardware) settings.plants = readPlants(root, *settings.hardware);
  settings.serial = readConnection(root);
  if (settings.hardware) readPacing(root, *settings.hardware);
  settings.stations = readStations(root, settings.serial);
}

void readAll(const Table& root, std::optional<Model> model, Settings& settings) {
  if (namesOnlyStations(root)) {
    if (const auto table = root.table("project")) readProject(*table, settings);
    settings.network = readNetwork(root);
    return;
  }
  const auto named = readModel(root);
  if (!model) model = named;
  if (model) choose(settings, *model);
  settings.parameters = CpuParameters::of(*settings.model);
  if (const auto table = root.table("project")) readProject(*table, settings);
  if (const auto table = root.table("program")) readProgram(*table, settings);
  settings.communication = readCommunication(root, *settings.model, !settings.control);
  settings.control ? readControl(root, *settings.control) : readStation(root, settings);
}

}  // namespace

std::optional<std::int64_t> readDateAndTime(const Table& table, std::string_view key) {
  const auto text = table.text(key, "a text like \"DT#2005-03-01-08:00:00\"");
  if (!text) return std::nullopt;
  const auto bcd = parseDateAndTime(*text, table.at(key));
  if (bcd) return millisecondsSince1990(bcd.value());
  table.problems().add(bcd.error());
  return std::nullopt;
}

std::string modelNames() {
  std::string list;
  for (const CpuModel& model : cpuModels())
    list += fmt::format("{}{}", list.empty() ? "" : ", ", model.keyword);
  return list + ", " + sinumerikModelNames();
}

std::optional<Model> findModel(std::string_view name) {
  if (const CpuModel* model = findCpuModel(name)) return Model{model, nullptr};
  if (const SinumerikModel* model = findSinumerikModel(name)) return Model{nullptr, model};
  return std::nullopt;
}

std::int64_t defaultStartOfClock() {
  return daysSince1990(1994, 1, 1).value_or(0) * kMillisecondsPerDay;
}

Settings readSettings(const source::SourceFile& file, Problems& problems,
                      std::optional<Model> model) {
  Settings settings;
  settings.startOfClock = defaultStartOfClock();
  if (model) choose(settings, *model);
  settings.parameters = CpuParameters::of(*settings.model);
  settings.communication = CommunicationParameters::of(*settings.model);
  const auto table = parseToml(file, problems);
  if (!table) return settings;
  readAll(Table(*table, "", Position{file.name(), 1, 1}, problems), model, settings);
  return settings;
}

}  // namespace merker::project
