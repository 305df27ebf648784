// What a CPU does: operating modes, communication status, diagnostic buffer (S7-DIAG-05).
#include <algorithm>

#include "base/bytes.h"
#include "system/szl.h"

namespace merker::system {
namespace {

// Numbers of operating modes in lists 16#xy24.
enum ModeNumber : std::uint8_t {
  kStop = 4,
  kColdRestart = 5,
  kWarmRestart = 6,
  kRun = 8,
  kHold = 10
};

struct Transition {
  const cpu::DiagnosticEvent* event = nullptr;
  std::uint8_t from = kStop, to = kStop;
};

// The mode that begins with this entry; 0: none does.
std::uint8_t modeAfter(std::uint16_t event, bool cold) {
  if (event == 0x4301) return static_cast<std::uint8_t>(cold ? kColdRestart : kWarmRestart);
  if (event == 0x4302 || event == 0x4306) return kRun;
  if (event == 0x4305) return kHold;
  const bool stop = event == 0x4303 || event == 0x4304 || (event >> 8) == 0x45;
  return static_cast<std::uint8_t>(stop ? kStop : 0);
}

// As the diagnostic buffer remembers them, oldest first.
std::vector<Transition> transitions(const cpu::Cpu& cpu) {
  std::vector<Transition> all;
  std::uint8_t mode = kStop;
  bool cold = false;
  for (const cpu::DiagnosticEvent& event : cpu.diagnostics().events()) {
    if (event.event >> 8 == 0x13) cold = event.event == 0x1385 || event.event == 0x1386;
    const std::uint8_t next = modeAfter(event.event, cold);
    if (next == 0) continue;
    all.push_back({&event, mode, next});
    mode = next;
  }
  return all;
}

void transition(SzlList& list, const Transition& t) {
  list.word(t.event->event);
  list.byte(0);
  list.byte(static_cast<std::uint32_t>(t.from) << 4 | t.to);
  list.dword(0);
  list.dword(0);
  for (const std::uint8_t byte : t.event->stamp) list.byte(byte);
}

void diagnosticEvent(SzlList& list, const cpu::DiagnosticEvent& event) {
  list.word(event.event);
  for (const std::uint8_t byte : event.info) list.byte(byte);
  for (const std::uint8_t byte : event.stamp) list.byte(byte);
}

void timeSystem(const SzlSource& source, SzlList& list) {
  cpu::Cpu& cpu = source.cpu;
  const Instant now = cpu.machine().clock;
  std::uint32_t running = 0, overflow = 0;
  list.word(8);
  list.dword(0);  // cycle of synchronisation, correction
  for (std::size_t i = 0; i < 8; ++i) {
    const bool exists = i < cpu.runtimeMeters().size();
    const cpu::RuntimeMeter meter = exists ? cpu.runtimeMeters()[i] : cpu::RuntimeMeter{};
    list.word(static_cast<std::uint32_t>(meter.hours(now)));
    running |= static_cast<std::uint32_t>(meter.running) << i;
    overflow |= static_cast<std::uint32_t>(meter.overflow(now)) << i;
  }
  for (const std::uint8_t byte : cpu::toDateAndTime(cpu.clock().milliseconds(now))) list.byte(byte);
  list.word(running << 8);
  list.word(overflow << 8);
}

// Protection levels by the switch, by parameters (0: no password) and the one that counts; position
// of the mode switch.
void protection(const cpu::Cpu& cpu, SzlList& list) {
  using enum cpu::SwitchPosition;
  const cpu::SwitchPosition position = cpu.modeSwitch().position();
  const std::uint32_t bySwitch = position == Run ? 2 : 1;
  const auto& parameters = cpu.parameters();
  const std::uint32_t byPassword = parameters.password.empty() ? 0u : parameters.protection;
  list.word(4);
  list.word(bySwitch);
  list.word(byPassword);
  list.word(std::max(bySwitch, byPassword));
  list.word(position == Run ? 1 : position == RunP ? 2 : position == Stop ? 3 : 4);
}

Communication communicationOf(const SzlSource& source) {
  if (source.communication != nullptr) return *source.communication;
  return {CommunicationParameters::of(*source.cpu.machine().model), {}};
}

// INDEX 1: connections kept for PG and OP, those that each of them has, configured ones and how
// many of these stand, free ones and how many of these are in use, communication load.
void connectionStatus(const SzlSource& source, SzlList& list) {
  const Communication now = communicationOf(source);
  const CommunicationParameters& set = now.parameters;
  const auto beyond = [](std::uint32_t used, std::uint32_t kept) {
    return used > kept ? used - kept : 0;
  };
  const std::uint32_t kept = set.pg + set.op + set.basic;
  list.word(1);
  list.word(set.pg), list.word(set.op);
  list.word(now.used[0]), list.word(now.used[1]);
  list.word(0), list.word(0);
  list.word(beyond(now.connections(), kept));
  list.word(beyond(now.used[0], set.pg) + beyond(now.used[1], set.op) +
            beyond(now.used[2], set.basic));
  list.word(source.cpu.parameters().communicationLoad);
}

}  // namespace

void szlAllModes(const SzlSource& source, std::uint32_t, SzlList& list) {
  for (const Transition& t : transitions(source.cpu)) transition(list, t);
}

void szlLastMode(const SzlSource& source, std::uint32_t, SzlList& list) {
  const std::vector<Transition> all = transitions(source.cpu);
  if (!all.empty()) transition(list, all.back());
}

// The mode alone, as an S7-300 answers programming devices: they look at the whole byte.
void szlCurrentMode(const SzlSource& source, std::uint32_t, SzlList& list) {
  const std::vector<Transition> all = transitions(source.cpu);
  list.word(all.empty() ? 0u : all.back().event->event);
  list.byte(0xFF);
  list.byte(all.empty() ? std::uint8_t{kStop} : all.back().to);
  list.dword(0);
  list.dword(0);
  for (std::size_t i = 0; i < 8; ++i) list.byte(all.empty() ? 0u : all.back().event->stamp[i]);
}

// INDEX: the mode in its low byte.
void szlOneMode(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const std::vector<Transition> all = transitions(source.cpu);
  const auto last = std::find_if(all.rbegin(), all.rend(),
                                 [&](const Transition& t) { return t.to == (index & 0xFF); });
  if (last != all.rend()) transition(list, *last);
}

void szlCommunication(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if (index == 1) connectionStatus(source, list);
  if (index == 4) protection(source.cpu, list);
  if (index == 8) timeSystem(source, list);
  if (!list.data.empty()) list.data.resize(list.recordLength);
}

void szlProtection(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if (index == 4) szlCommunication(source, index, list);
}

// INDEX 1: bytes of a PDU, connections, bit/s of MPI (S7-LIM-01, -05, S7-NET-25).
void szlConnections(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if (index != 1) return;
  const Communication now = communicationOf(source);
  list.word(1);
  list.word(now.parameters.pdu);
  list.word(now.connections());
  list.dword(187'500);
  list.data.resize(list.recordLength);
}

// The newest entry first.
void szlLatestDiagnostics(const SzlSource& source, std::uint32_t count, SzlList& list) {
  const auto& events = source.cpu.diagnostics().events();
  const std::size_t most = std::min<std::size_t>(count, events.size());
  for (std::size_t i = 0; i < most; ++i) diagnosticEvent(list, events[events.size() - 1 - i]);
}

void szlDiagnostics(const SzlSource& source, std::uint32_t, SzlList& list) {
  szlLatestDiagnostics(source, cpu::Diagnostics::kCapacity, list);
}

// LED number, on, blinking: 1 = 2 Hz, 2 = 0.5 Hz.
void szlLeds(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const cpu::Leds leds = source.cpu.leds();
  struct Led {
    std::uint32_t number;
    cpu::Light light;
  };
  const Led all[] = {{0x01, leds.sf},   {0x04, leds.run},  {0x05, leds.stop},
                     {0x06, leds.frce}, {0x08, leds.batf}, {0x0B, leds.bf}};
  for (const Led& led : all) {
    if (index != 0 && index != led.number) continue;
    list.word(led.number);
    list.byte(led.light != cpu::Light::Off);
    list.byte(led.light == cpu::Light::Fast ? 1 : led.light == cpu::Light::Slow ? 2 : 0);
  }
}

}  // namespace merker::system
