// CPUs with the ASCII driver, for tests.
#pragma once

#include "stations.h"

namespace merker::serial {

// A CPU with the ASCII driver and a partner with a script.
class AsciiCpu {
 public:
  explicit AsciiCpu(const AsciiParameters& parameters = {}, const Settings& settings = {},
                    const MailboxParameters& buffer = {})
      : mail(buffer),
        cpu(parameters, mail),
        lines(cpu, partner, settings, settings, settings.mode == Mode::TwoWire) {}
  void send(const Bytes& data) { cpu.send(data, lines.now); }
  std::string end() { return number(cpu.outbox().takeEnd()); }
  std::string take() {
    const auto entry = mail.take();
    cpu.fetched();
    lines.poke();
    if (!entry) return "none";
    return entry->event == Event::None ? text(entry->telegram) : number(entry->event);
  }
  std::string mailbox() {
    std::string result;
    for (std::string next = take(); next != "none"; next = take())
      result += (result.empty() ? "" : "; ") + next;
    return result;
  }
  std::string sent(std::size_t port) {
    Bytes bytes;
    for (const Sighting& s : lines.seen)
      if (s.port == port) bytes.push_back(s.value);
    return text(bytes);
  }

  Mailbox mail;
  Ascii cpu;
  Script partner;
  Coupled lines;
};

inline AsciiParameters byCount(std::uint16_t length) {
  AsciiParameters parameters;
  parameters.end = AsciiParameters::End::Count;
  parameters.length = length;
  return parameters;
}

inline AsciiParameters byEnd(std::uint8_t end1 = 0x03) {
  AsciiParameters parameters;
  parameters.end = AsciiParameters::End::Characters;
  parameters.end1 = end1;
  return parameters;
}

inline AsciiParameters byTwoEnds(std::uint8_t end1 = 0x0D, std::uint8_t end2 = 0x0A) {
  AsciiParameters parameters = byEnd(end1);
  parameters.endCharacters = 2;
  parameters.end2 = end2;
  return parameters;
}

inline AsciiParameters withFlow(AsciiParameters parameters = {}) {
  parameters.flowControl = true;
  return parameters;
}

}  // namespace merker::serial
