#include "workbench/serial_rows.h"

#include <fmt/format.h>

#include "io/amount.h"
#include "project/project.h"
#include "serial/parameters.h"

namespace merker::workbench {
namespace {

using serial::Parameters;
using serial::Protocol;
using End = serial::AsciiParameters::End;

// Rows of one page. The keys are those of [module.serial].
class Page {
 public:
  Page(Json& list, const char* name) : list_(list), name_(name) {}

  void number(const char* key, unsigned value, unsigned low, unsigned high, bool used = true) {
    add(key, "number", value, {{"min", low}, {"max", high}}, used);
  }
  void time(const char* key, Duration value, const char* hint, bool used = true) {
    add(key, "length", io::formatLength(value), {{"hint", hint}}, used);
  }
  void flag(const char* key, bool value, bool used = true) {
    add(key, "flag", value, Json::object(), used);
  }
  void choice(const char* key, Json value, Json choices, bool used = true) {
    add(key, "choice", std::move(value), {{"choices", std::move(choices)}}, used);
  }
  // One character, or a list of them.
  void characters(const char* key, Json value, bool used) {
    add(key, "characters", std::move(value), Json::object(), used);
  }

 private:
  void add(const char* key, const char* kind, Json value, Json more, bool used) {
    more.update({{"key", fmt::format("serial.{}", key)},
                 {"kind", kind},
                 {"value", std::move(value)},
                 {"page", name_}});
    if (!used) more["fixed"] = true;
    list_.push_back(std::move(more));
  }

  Json& list_;
  const char* name_;
};

template <typename Value, std::size_t size>
Json word(const char* const (&words)[size], Value value) {
  return words[static_cast<std::size_t>(value)];
}

const char* protocolOf(const Parameters& p) {
  if (p.protocol == Protocol::Ascii) return "ASCII";
  if (p.protocol == Protocol::ComputerLink) return "RK512";
  return p.procedure.blockCheck ? "3964R" : "3964";
}

// PTP-PARAM-02, PTP-OVW-02
void addBasic(const Parameters& p, Json& list) {
  constexpr const char* kStop[] = {"continue", "stop"};
  Page page(list, "basic");
  page.choice("protocol", protocolOf(p), {"ASCII", "3964", "3964R", "RK512"});
  page.choice("cpu_stop", word(kStop, p.discardInStop), kStop);
}

// PTP-PARAM-07, -08, -26, -34: 7 data bits need a parity; RK 512 has 8.
void addFrame(const Parameters& p, Page& page) {
  constexpr const char* kParities[] = {"none", "odd", "even"};
  const serial::Frame& frame = p.line.frame;
  Json parities = frame.dataBits == 7 ? Json{"odd", "even"} : Json(kParities);
  page.choice("baud", p.line.baud, {300, 600, 1200, 2400, 4800, 9600, 19'200, 38'400});
  page.choice("data_bits", frame.dataBits, {7, 8}, p.protocol != Protocol::ComputerLink);
  page.choice("stop_bits", frame.stopBits, {1, 2});
  page.choice("parity", word(kParities, frame.parity), std::move(parities));
}

// PTP-PARAM-09 to -11, PTP-PHY-09
void addFlowControl(const Parameters& p, Page& page) {
  constexpr const char* kFlow[] = {"none", "XON/XOFF"};
  const serial::AsciiParameters& a = p.ascii;
  page.choice("flow_control", word(kFlow, a.flowControl), kFlow,
              p.line.mode == serial::Mode::PointToPoint);
  page.characters("xon", a.xon, a.flowControl);
  page.characters("xoff", a.xoff, a.flowControl);
  page.time("xon_wait", a.xonWait, "20s", a.flowControl);
}

// PTP-PARAM-12 to -19
void addEnd(const Parameters& p, Json& list) {
  constexpr const char* kBothEnds[] = {"delay", "count", "characters"};
  constexpr const char* kSending[] = {"up to end", "length", "append"};
  const serial::AsciiParameters& a = p.ascii;
  const bool counted = a.end == End::Count, marked = a.end == End::Characters;
  Json marks = Json::array({a.end1});
  if (a.endCharacters == 2) marks.push_back(a.end2);
  Page page(list, "end");
  page.choice("end", word(kBothEnds, a.end), kBothEnds);
  page.time("character_delay", a.delay, "4ms");
  page.flag("pause", a.pause, counted);
  page.number("length", a.length, 1, 1024, counted);
  page.characters("end_characters", std::move(marks), marked);
  page.choice("check_characters", a.checkCharacters, {0, 1, 2}, marked);
  page.choice("sending", word(kSending, a.sending), kSending, marked);
}

// PTP-PARAM-27 to -32
void addProcedure(const Parameters& p, Json& list) {
  constexpr const char* kPriorities[] = {"low", "high"};
  const serial::ProcedureParameters& q = p.procedure;
  Page page(list, "telegram");
  page.choice("priority", word(kPriorities, q.highPriority), kPriorities);
  if (p.protocol == Protocol::ComputerLink) page.flag("block_check", q.blockCheck);
  page.time("character_delay", q.characterDelay, "220ms");
  page.time("acknowledge_delay", q.acknowledgeDelay, q.blockCheck ? "2s" : "550ms");
  page.number("setup_attempts", q.setups, 1, 255);
  page.number("transmission_attempts", q.transmissions, 1, 255);
}

// PTP-PARAM-20 to -23, -34
void addReception(const Parameters& p, Json& list) {
  if (p.protocol == Protocol::ComputerLink) return;
  Page page(list, "reception");
  page.flag("clear_at_start", p.mailbox.clearAtStart);
  page.flag("prevent_overwriting", p.mailbox.preventOverwriting);
  page.flag("whole_buffer", p.mailbox.wholeBuffer);
  page.number("telegrams", p.mailbox.telegrams, 1, 10, !p.mailbox.wholeBuffer);
}

// PTP-PARAM-24, -25, -33; PTP-PHY-08: the procedures have four wires.
void addInterface(const Parameters& p, Json& list) {
  constexpr const char* kModes[] = {"RS422", "RS422 master", "RS485"};
  constexpr const char* kPresets[] = {"none", "break", "idle"};
  const auto mode = p.line.mode == serial::Mode::TwoWire            ? 2U
                    : p.line.mode == serial::Mode::MultipointMaster ? 1U
                                                                    : 0U;
  Page page(list, "interface");
  page.choice("mode", word(kModes, mode), kModes, p.protocol == Protocol::Ascii);
  page.choice("preset", word(kPresets, p.line.preset),
              mode == 0 ? Json(kPresets) : Json{"none", "idle"});
}

}  // namespace

void addSerialRows(const io::Parameters& parameters, Json& list) {
  for (Json& row : list)
    row["page"] = row["key"] == "name"          ? "general"
                  : row["key"] == "diagnostics" ? "basic"
                                                : "addresses";
  if (!parameters.serial) return;
  const Parameters& p = *parameters.serial;
  addBasic(p, list);
  Page transmission(list, "transmission");
  addFrame(p, transmission);
  if (p.protocol == Protocol::Ascii) {
    addFlowControl(p, transmission);
    addEnd(p, list);
  } else {
    addProcedure(p, list);
  }
  addReception(p, list);
  addInterface(p, list);
}

void raiseSerialTimes(project::SettingsEdit& edit, const project::ModulePlace& place) {
  const project::Project planned = project::loadConfiguration("", edit.text(), {});
  const io::Module* module = planned.hardware ? planned.hardware->find(place.slot) : nullptr;
  if (module == nullptr || !module->parameters.serial) return;
  const Parameters& p = *module->parameters.serial;
  const Duration least = serial::leastCharacterDelay(p.protocol, p.line.baud);
  const auto raise = [&](const char* key, Duration time) {
    if (time < least) edit.set(place, key, fmt::format("\"{}\"", io::formatLength(least)));
  };
  const bool ascii = p.protocol == Protocol::Ascii;
  raise("serial.character_delay", ascii ? p.ascii.delay : p.procedure.characterDelay);
  if (!ascii) raise("serial.acknowledge_delay", p.procedure.acknowledgeDelay);
}

}  // namespace merker::workbench
