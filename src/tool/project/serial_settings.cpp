// [module.serial] of the sub-module 2.1: the masks of the technology manual 6.3.3 to 6.3.6
// (PTP-PARAM); [serial]: what the interface is connected to.
#include <fmt/format.h>

#include <algorithm>

#include "io/amount.h"
#include "project/readers.h"
#include "serial/parameters.h"

namespace merker::project {
namespace {

using serial::Protocol;

using Keys = std::vector<std::string_view>;
const Keys kCommon{"protocol", "baud", "data_bits", "parity", "stop_bits", "preset", "cpu_stop"};
const Keys kBuffer{"clear_at_start", "prevent_overwriting", "whole_buffer", "telegrams"};
const Keys kAscii{
    "mode",   "flow_control",    "xon",   "xoff",           "xon_wait",         "end",
    "length", "character_delay", "pause", "end_characters", "check_characters", "sending"};
const Keys kProcedure{"priority", "character_delay", "acknowledge_delay", "setup_attempts",
                      "transmission_attempts"};

// Keys that mean nothing without a choice (PTP-PARAM-11, -14 to -18, -23).
struct Need {
  std::string_view key, choice;
  bool (*holds)(const serial::Parameters&);
};
using End = serial::AsciiParameters::End;
constexpr auto kCounted = [](const serial::Parameters& p) { return p.ascii.end == End::Count; };
constexpr auto kMarked = [](const serial::Parameters& p) { return p.ascii.end == End::Characters; };
constexpr auto kFlowControl = [](const serial::Parameters& p) { return p.ascii.flowControl; };
constexpr auto kLimited = [](const serial::Parameters& p) { return !p.mailbox.wholeBuffer; };
constexpr Need kNeeds[] = {{"length", "end = \"count\"", kCounted},
                           {"pause", "end = \"count\"", kCounted},
                           {"end_characters", "end = \"characters\"", kMarked},
                           {"check_characters", "end = \"characters\"", kMarked},
                           {"sending", "end = \"characters\"", kMarked},
                           {"xon", "flow_control = \"XON/XOFF\"", kFlowControl},
                           {"xoff", "flow_control = \"XON/XOFF\"", kFlowControl},
                           {"xon_wait", "flow_control = \"XON/XOFF\"", kFlowControl},
                           {"telegrams", "whole_buffer = false", kLimited}};

// What a refusal speaks of, and the key that sets it.
struct KeyOf {
  std::string_view parameter, key;
};
constexpr KeyOf kParameterKeys[] = {{"data bits", "data_bits"},
                                    {"stop bits", "stop_bits"},
                                    {"flow control", "flow_control"},
                                    {"character delay time", "character_delay"},
                                    {"acknowledgement delay time", "acknowledge_delay"},
                                    {"telegram length", "length"},
                                    {"number of end characters", "end_characters"},
                                    {"end character 1", "end_characters"},
                                    {"end character 2", "end_characters"},
                                    {"number of block check characters", "check_characters"},
                                    {"XON", "xon"},
                                    {"XOFF", "xoff"},
                                    {"waiting time for XON", "xon_wait"},
                                    {"set-up attempts", "setup_attempts"},
                                    {"transmission attempts", "transmission_attempts"},
                                    {"buffered telegrams", "telegrams"}};

std::string_view keyOf(std::string_view parameter) {
  const auto* found = std::ranges::find(kParameterKeys, parameter, &KeyOf::parameter);
  return found == std::end(kParameterKeys) ? parameter : found->key;
}

struct SerialReader {
  const Table& table;
  serial::Parameters& p;

  template <typename Value>
  void integer(std::string_view key, std::int64_t low, std::int64_t high, Value& value) {
    if (const auto read = table.integer(key, low, high)) value = static_cast<Value>(*read);
  }
  void flag(std::string_view key, bool& value) { value = table.flag(key).value_or(value); }
  template <typename Value>
  void choice(std::string_view key, std::initializer_list<std::string_view> words, Value& value) {
    if (const auto read = table.choice(key, words)) value = static_cast<Value>(*read);
  }
  void time(std::string_view key, Duration& value);
  void line();
  void ascii();
  void endCharacters();
  void procedure();
  void buffer();
  void needs(const Keys& allowed);
  void refuse();
};

// A time that is not given follows the rate (PTP-PARAM-37).
void SerialReader::time(std::string_view key, Duration& value) {
  constexpr Duration kLongest = Duration::seconds(100);
  if (!table.has(key))
    value = serial::settable(p.protocol, p.line.baud, value);
  else if (const auto read = table.length(key, Duration{}, kLongest))
    value = *read;
}

// PTP-PARAM-02, -07, -08, -26
void SerialReader::line() {
  integer("baud", 0, 1'000'000, p.line.baud);
  integer("data_bits", 0, 255, p.line.frame.dataBits);
  integer("stop_bits", 0, 255, p.line.frame.stopBits);
  choice("parity", {"none", "odd", "even"}, p.line.frame.parity);
  choice("cpu_stop", {"continue", "stop"}, p.discardInStop);
}

// PTP-PARAM-12 to -19
void SerialReader::ascii() {
  serial::AsciiParameters& a = p.ascii;
  bool twoWire = false;
  std::size_t mode = 0;
  choice("mode", {"RS422", "RS422 master", "RS485"}, mode);
  twoWire = mode == 2;
  p.line.mode = twoWire     ? serial::Mode::TwoWire
                : mode == 1 ? serial::Mode::MultipointMaster
                            : serial::Mode::PointToPoint;
  choice("flow_control", {"none", "XON/XOFF"}, a.flowControl);
  integer("xon", 0, 255, a.xon);
  integer("xoff", 0, 255, a.xoff);
  if (const auto wait = table.length("xon_wait", Duration{}, Duration::seconds(100)))
    a.xonWait = *wait;
  choice("end", {"delay", "count", "characters"}, a.end);
  time("character_delay", a.delay);
  integer("length", 0, 65'535, a.length);
  flag("pause", a.pause);
  endCharacters();
  choice("sending", {"up to end", "length", "append"}, a.sending);
  if (p.line.baud == 38'400 && !twoWire) table.problems().add(ProblemCode::P0771, table.at("baud"));
}

void SerialReader::endCharacters() {
  serial::AsciiParameters& a = p.ascii;
  integer("check_characters", 0, 2, a.checkCharacters);
  if (!table.has("end_characters")) return;
  const auto list = table.numbers("end_characters", "one or two characters: [0x0D, 0x0A]");
  const bool bytes =
      std::ranges::all_of(list, [](const Table::Number& n) { return n.value < 256; });
  if (list.empty() || list.size() > 2 || !bytes)
    return table.mustBe("end_characters", "one or two characters: [0x0D, 0x0A]");
  a.endCharacters = static_cast<std::uint8_t>(list.size());
  a.end1 = static_cast<std::uint8_t>(list[0].value);
  if (list.size() == 2) a.end2 = static_cast<std::uint8_t>(list[1].value);
}

// PTP-PARAM-27 to -32
void SerialReader::procedure() {
  serial::ProcedureParameters& q = p.procedure;
  choice("priority", {"low", "high"}, q.highPriority);
  q.acknowledgeDelay = serial::defaultAcknowledgeDelay(q.blockCheck);
  time("character_delay", q.characterDelay);
  time("acknowledge_delay", q.acknowledgeDelay);
  integer("setup_attempts", 1, 255, q.setups);
  integer("transmission_attempts", 1, 255, q.transmissions);
}

// PTP-PARAM-20 to -23
void SerialReader::buffer() {
  flag("clear_at_start", p.mailbox.clearAtStart);
  flag("prevent_overwriting", p.mailbox.preventOverwriting);
  flag("whole_buffer", p.mailbox.wholeBuffer);
  integer("telegrams", 0, 255, p.mailbox.telegrams);
}

void SerialReader::needs(const Keys& allowed) {
  for (const Need& need : kNeeds)
    if (table.has(need.key) && !need.holds(p) && std::ranges::count(allowed, need.key) > 0)
      table.problems().add(ProblemCode::P0744, table.placeOf(need.key), need.key, need.choice);
}

// What the manual refuses, and the time that would be right (PTP-PARAM-36). The waiting time for
// XON has the limits that the procedure has at the usual rates.
void SerialReader::refuse() {
  constexpr std::uint32_t kAnyRate = 9600;
  for (const serial::Refusal& refusal : check(p)) {
    std::string text = refusal.text;
    const std::string_view key = keyOf(refusal.parameter);
    const bool wait = key == "xon_wait";
    const bool time = wait || key == "character_delay" || key == "acknowledge_delay";
    if (const auto given =
            time ? table.length(key, Duration{}, Duration::seconds(100)) : std::nullopt)
      text += fmt::format(
          "; {} is possible",
          io::formatLength(wait ? serial::settable(Protocol::Procedure, kAnyRate, *given)
                                : serial::settable(p.protocol, p.line.baud, *given)));
    table.problems().add(ProblemCode::P0769, table.at(key), text);
  }
}

Keys keysOf(Protocol protocol) {
  Keys keys = kCommon;
  const auto add = [&keys](const Keys& more) { keys.insert(keys.end(), more.begin(), more.end()); };
  add(protocol == Protocol::Ascii ? kAscii : kProcedure);
  if (protocol == Protocol::ComputerLink)
    keys.push_back("block_check");
  else
    add(kBuffer);
  return keys;
}

// PTP-OVW-01, -02; the procedure without block check is a protocol of its own here.
bool readProtocol(const Table& table, const CpuModel& model, serial::Parameters& p) {
  const auto word = table.choice("protocol", {"ASCII", "3964", "3964R", "RK512"});
  if (!word) return !table.has("protocol");
  constexpr Protocol kProtocols[] = {Protocol::Ascii, Protocol::Procedure, Protocol::Procedure,
                                     Protocol::ComputerLink};
  p = serial::defaults(kProtocols[*word]);
  p.procedure.blockCheck = *word != 1;
  if (p.protocol != Protocol::ComputerLink || model.onBoard.computerLink) return true;
  table.problems().add(ProblemCode::P0737, table.at("protocol"), "protocol \"RK512\"", model.name,
                       "ASCII, 3964, 3964R");
  return false;
}

void readSerialTable(const Table& table, const CpuModel& model, serial::Parameters& p) {
  if (!readProtocol(table, model, p)) return;
  table.allow(keysOf(p.protocol));
  SerialReader reader{table, p};
  reader.line();
  if (p.protocol == Protocol::ComputerLink) reader.flag("block_check", p.procedure.blockCheck);
  p.protocol == Protocol::Ascii ? reader.ascii() : reader.procedure();
  if (p.protocol != Protocol::ComputerLink) reader.buffer();
  p.line.preset = serial::defaultPreset(p.line.mode);
  reader.choice("preset", {"none", "break", "idle"}, p.line.preset);
  reader.needs(keysOf(p.protocol));
  reader.refuse();
}

}  // namespace

void readSerial(const Table& table, const CpuModel& model, io::Module& module) {
  if (!table.has("serial")) return;
  const auto serial = table.table("serial");
  if (module.type->kind != ModuleKind::PointToPoint)
    return table.problems().add(ProblemCode::P0735, table.placeOf("serial"), module.title(),
                                "serial interface; only the sub-module 2.1 is one");
  if (!serial) return;
  auto parameters = std::make_shared<serial::Parameters>(*module.parameters.serial);
  readSerialTable(*serial, model, *parameters);
  module.parameters.serial = std::move(parameters);
}

std::optional<serial::Connection> readConnection(const Table& root) {
  const auto table = root.table("serial");
  if (!table) return std::nullopt;
  table->allow({"X27", "pacing"});
  const auto text = table->text("X27", "a connection: \"listen:4000\"");
  if (!text) return std::nullopt;
  auto connection = serial::parseConnection(*text);
  if (!connection)
    table->problems().add(ProblemCode::P0770, table->at("X27"), *text, serial::connectionForms());
  return connection;
}

// The line is no part of the S7 project, but it is the sub-module's (PTP-LINE-07).
void readPacing(const Table& root, io::Configuration& configuration) {
  const auto table = root.table("serial");
  const auto pacing = table ? table->choice("pacing", {"unlimited", "rate"}) : std::nullopt;
  if (!pacing) return;
  for (io::Module& module : configuration.modules) {
    if (!module.parameters.serial) continue;
    auto parameters = std::make_shared<serial::Parameters>(*module.parameters.serial);
    parameters->paced = *pacing == 1;
    module.parameters.serial = std::move(parameters);
  }
}

}  // namespace merker::project
