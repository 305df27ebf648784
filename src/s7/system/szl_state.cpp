// What a CPU does: operating modes, diagnostic buffer, LEDs (S7-DIAG-05).
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
  const cpu::Leds leds = communicationOf(source).seen(source.cpu.leds());
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
