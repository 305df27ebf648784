// merker.toml of a SINUMERIK: [machine_data], [plc], [alarm_texts].
#include <fmt/format.h>

#include "project/numbered_keys.h"
#include "project/readers.h"
#include "step5/variable.h"

namespace merker::project {
namespace {

// S5-MD: limits of single words are the PLC's own, it stops with 6116 … 6123.
constexpr KeyRange kMachineData[] = {
    {0, 9, 0, 0xFFFF}, {155, 155, 0, 0xFF}, {1000, 1007, 0, 0xFFFF}, {2000, 2010, 0, 0xFF}};

void readMachineData(const Table& table, cnc::Options& options) {
  eachNumber(table, kMachineData, "0 to 9, 155, 1000 to 1007, 2000 to 2010",
             [&](unsigned number, std::int64_t value) {
               options.machineData.push_back({number, static_cast<std::uint16_t>(value)});
             });
}

constexpr std::uint32_t kLastFlagByte = 255;

// "MB 100" or "DB 20.DW 0": where 64 alarm bits begin (OP-55).
std::optional<sinumerik::BitField> readField(const Table& table, std::string_view key) {
  constexpr std::string_view kForm = "the first of 8 bytes: \"MB 100\" or \"DB 20.DW 0\"";
  const auto text = table.text(key, kForm);
  if (!text) return std::nullopt;
  const auto variable = step5::parseVariable(*text);
  const bool flags =
      variable && variable->operand.area == Area::Flag && variable->operand.width == Width::Byte;
  const bool data = variable && variable->operand.area == Area::DataBlock &&
                    variable->operand.width == Width::Word;
  const std::uint32_t byte = variable ? variable->operand.value / 8 : 0;
  const bool room = flags && byte <= kLastFlagByte - 7;
  if (room) return sinumerik::BitField{0, byte};
  if (data) return sinumerik::BitField{static_cast<std::uint16_t>(variable->db), byte / 2};
  table.mustBe(key, flags ? "MB 0 to MB 248: there are 64 bits in 8 bytes" : kForm);
  return std::nullopt;
}

// What the delivered control has (S5-FM-02, S5-FM-34 error 8, OP-09).
void readVariant(const Table& table, cnc::Options& options) {
  if (const auto order = table.choice("md_2003", {"table", "text"}))
    options.bits = *order == 0 ? sinumerik::BitMapping::Table : sinumerik::BitMapping::Text;
  nc::MacroOptions& macros = options.macros;
  macros.exchange.enabled = table.flag("nc_data_exchange").value_or(macros.exchange.enabled);
  macros.actualValueMacros = table.flag("actual_value_macros").value_or(macros.actualValueMacros);
  if (const auto model = table.choice("technology", {"T", "M", "N", "G"}))
    macros.exchange.model = static_cast<nc::Model>(*model);
}

// [[module]]: which bytes have a module. What is wrong with them the PLC finds when it starts
// (6100, 6125 to 6128).
std::optional<sinumerik::Module> readPeriphery(const Table& table) {
  table.allow({"name", "input", "output", "bytes", "distributed", "fitted"});
  sinumerik::Module module;
  if (table.has("input") == table.has("output")) {
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "either input or output, its first byte: input = 0");
    return std::nullopt;
  }
  module.output = table.has("output");
  module.first = table.number(module.output ? "output" : "input", 0, 127).value_or(0);
  module.bytes = table.number("bytes", 1, 64).value_or(1);
  module.distributed = table.flag("distributed").value_or(false);
  module.fitted = table.flag("fitted").value_or(true);
  if (const auto name = table.text("name", "a text")) module.name = *name;
  return module;
}

void readModules(const Table& root, cnc::Options& options) {
  if (!root.has("module")) return;
  auto& modules = options.plc.surroundings.modules;
  modules.clear();
  for (const Table& table : root.tables("module"))
    if (auto module = readPeriphery(table)) modules.push_back(std::move(*module));
}

void readCoupling(const Table& table, cnc::Options& options) {
  table.allow({"partner", "role"});
  const auto role = table.choice("role", {"control", "master"});
  const auto partner = table.text("partner", "the project folder of the other control");
  if (!table.has("partner"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "the project folder of the other control: partner = \"../press\"");
  if (!partner) return;
  const nc::Side side = role.value_or(0) == 0 ? nc::Side::Control : nc::Side::Master;
  options.coupling = cnc::CouplingOptions{*partner, table.at("partner"), side};
}

void readPlc(const Table& table, cnc::Options& options) {
  table.allow({"software", "memory_extension", "eprom_data_blocks", "alarms", "messages", "md_2003",
               "nc_data_exchange", "actual_value_macros", "technology"});
  readVariant(table, options);
  if (const auto software = table.number("software", 1, 2))
    options.plc.software = *software == 1 ? sinumerik::Software::Sw1 : sinumerik::Software::Sw2;
  if (const auto extension = table.flag("memory_extension"))
    options.plc.memoryExtension = *extension;
  for (const Table::Number& db : table.numbers("eprom_data_blocks", "numbers of data blocks"))
    if (db.value > 0 && db.value < options.plc.dataInEprom.size())
      options.plc.dataInEprom.set(db.value);
    else
      table.problems().add(ProblemCode::P1102, db.position, fmt::format("DB {}", db.value),
                           "DB 1..255");
  options.plc.userAlarms.alarms = readField(table, "alarms");
  options.plc.userAlarms.messages = readField(table, "messages");
  options.alarmsNamed = table.placeOf("alarms");
  options.messagesNamed = table.placeOf("messages");
}

// The history has 200 alarms with their texts, and each look at it sends them.
constexpr std::size_t kLongestAlarm = 200;

void readAlarmText(const Table& table, const std::string& key, std::string& to) {
  const auto text = table.text(key, "the text of the alarm");
  if (text && text->size() > kLongestAlarm)
    table.mustBe(key, fmt::format("a text of at most {} bytes", kLongestAlarm));
  else if (text)
    to = *text;
}

void readAlarmTexts(const Table& table, cnc::Options& options) {
  for (const std::string& key : table.keys()) {
    const auto number = keyNumber(key);
    const bool known =
        number && ((*number >= 6000 && *number <= 6063) || (*number >= 7000 && *number <= 7063));
    if (!known)
      unknownKey(table, key, "6000 to 6063, 7000 to 7063");
    else
      readAlarmText(table, key, options.plc.userAlarms.texts[*number]);
  }
}

}  // namespace

void readControl(const Table& root, cnc::Options& options) {
  root.allow({"project", "program", "cpu", "machine_data", "plc", "alarm_texts", "nc", "module",
              "coupling", "communication"});
  if (const auto table = root.table("cpu")) table->allow({"model"});
  if (const auto table = root.table("machine_data")) readMachineData(*table, options);
  if (const auto table = root.table("plc")) readPlc(*table, options);
  if (const auto table = root.table("alarm_texts")) readAlarmTexts(*table, options);
  if (const auto table = root.table("nc")) readNc(*table, options.control);
  readModules(root, options);
  if (const auto table = root.table("coupling")) readCoupling(*table, options);
}

}  // namespace merker::project
