#include "scenario/expectations/serial.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text.h"
#include "scenario/line.h"
#include "scenario/serial_text.h"
#include "scenario/steps/serial.h"

namespace merker::simulator::expectations {
namespace {

// Timers and counters are words.
std::size_t offsetOf(const serial::LinkJob& job) {
  return job.type == 'T' || job.type == 'Z' ? 2U * job.offset : job.offset;
}

}  // namespace

// X27 received BYTES | X27 received nothing | X27 memory AREA = BYTES | X27 ended 0703
bool Serial::parse(const StepLine& line, const Claim& claim) {
  std::string_view rest = claim.subject;
  const std::string_view name = takeWord(rest), verb = takeWord(rest);
  port = name;
  portPosition = line.at(name);
  if (equalsIgnoreCase(verb, "received"))
    return equalsIgnoreCase(rest, "nothing") || parseCharacters(line, rest, bytes);
  if (equalsIgnoreCase(verb, "ended")) {
    of = Of::Ended;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value, 16);
    if (rest.size() != 4 || error != std::errc{} || end != rest.data() + rest.size())
      return line.fail(ProblemCode::P0952, rest.empty() ? claim.whole : rest,
                       "a number as STATUS has it: 0000, 0703");
    event = static_cast<serial::Event>(value);
    return true;
  }
  if (equalsIgnoreCase(verb, "memory")) {
    of = Of::Memory;
    const std::string_view place = takeWord(rest);
    const auto area = parseArea(place);
    if (!area || takeWord(rest) != "=")
      return line.fail(ProblemCode::P0952, place.empty() ? claim.whole : place,
                       "DB10.DBB0 = BYTES");
    job = *area;
    return parseCharacters(line, rest, bytes);
  }
  return line.fail(ProblemCode::P0952, verb.empty() ? claim.whole : verb,
                   "received BYTES, received nothing, memory DB10.DBB0 = BYTES, or ended 0000");
}

void Serial::resolve(const StepBinding& binding) {
  steps::hasSerialPort(binding, port, portPosition);
}

bool Serial::holds(controller::Controller& plc) const {
  serial::Coupling* coupling = steps::couplingOf(plc);
  if (coupling == nullptr) return false;
  serial::Partner& partner = coupling->partner();
  switch (of) {
    case Of::Received:
      return partner.take(bytes);
    case Of::Memory:
      return partner.memory().get(job.type, job.block, offsetOf(job), bytes.size()) == bytes;
    case Of::Ended:
      return partner.ended() == event;
  }
  return false;
}

std::string Serial::actual(controller::Controller& plc) const {
  serial::Coupling* coupling = steps::couplingOf(plc);
  if (coupling == nullptr) return "there is no serial interface";
  if (coupling->joined()) return "X27 is connected to another station";
  const serial::Partner& partner = coupling->partner();
  switch (of) {
    case Of::Received:
      break;
    case Of::Memory:
      return "there is " +
             showCharacters(partner.memory().get(job.type, job.block, offsetOf(job), bytes.size()));
    case Of::Ended:
      return partner.ended()
                 ? fmt::format("it ended with {:04X}", static_cast<unsigned>(*partner.ended()))
                 : "nothing has ended";
  }
  if (partner.received().empty()) return "nothing was received";
  if (partner.speaks() != serial::Partner::Speaks::Characters)
    return "the telegram received is " + showCharacters(partner.received().front().bytes);
  serial::Bytes all;
  for (const auto& one : partner.received())
    if (all.size() < 100) all.insert(all.end(), one.bytes.begin(), one.bytes.end());
  return "received is " + showCharacters(all);
}

}  // namespace merker::simulator::expectations
