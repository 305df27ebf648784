#include "scenario/steps/serial.h"

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "scenario/duration.h"
#include "scenario/serial_text.h"
#include "scenario/step_binding.h"
#include "scenario/step_run.h"
#include "serial/serial_port.h"

namespace merker::simulator::steps {
namespace {

using Does = Serial::Does;
using End = serial::Coupling::End;

constexpr std::pair<std::string_view, Does> kVerbs[] = {
    {"send", Does::Send},       {"answer", Does::Answer},   {"partner", Does::Partner},
    {"job", Does::JobSend},     {"memory", Does::Memory},   {"cut", Does::Cut},
    {"connect", Does::Connect}, {"swap", Does::Swap},       {"straight", Does::Straight},
    {"noise", Does::Noise},     {"disturb", Does::Disturb}, {"forget", Does::Forget}};
constexpr std::string_view kVerbNames =
    "send, answer, partner, job, memory, cut, connect, swap, straight, noise, disturb or forget";

constexpr std::pair<std::string_view, serial::Fault::Kind> kDisturbances[] = {
    {"drop", serial::Fault::Kind::Drop},     {"duplicate", serial::Fault::Kind::Duplicate},
    {"flip", serial::Fault::Kind::Flip},     {"replace", serial::Fault::Kind::Replace},
    {"insert", serial::Fault::Kind::Insert}, {"parity", serial::Fault::Kind::Parity},
    {"stop", serial::Fault::Kind::Stop},     {"overrun", serial::Fault::Kind::Overrun},
    {"delay", serial::Fault::Kind::Delay}};

// 8E1, 7O2, 8N1
std::optional<serial::Frame> frameOf(std::string_view text) {
  if (text.size() != 3 || (text[0] != '7' && text[0] != '8') || (text[2] != '1' && text[2] != '2'))
    return std::nullopt;
  constexpr std::string_view kParities = "NOE";
  const auto parity = kParities.find(upper(text)[1]);
  if (parity == std::string_view::npos) return std::nullopt;
  return serial::Frame{static_cast<std::uint8_t>(text[0] - '0'),
                       static_cast<serial::Parity>(parity),
                       static_cast<std::uint8_t>(text[2] - '0')};
}

std::optional<std::uint32_t> numberOf(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// What only the partner of scenarios does; the wires and characters of a station are its own.
bool ofPartner(Does does) {
  constexpr Does kOfLine[] = {Does::Cut,      Does::Connect, Does::Swap,
                              Does::Straight, Does::Noise,   Does::Disturb};
  return std::ranges::find(kOfLine, does) == std::end(kOfLine);
}

// The text up to a word that stands alone outside of quotation marks, which is taken off.
std::string_view before(std::string_view& text, std::string_view word) {
  const auto place = findOutside(text, [word](std::string_view tail) {
    if ((tail.front() != ' ' && tail.front() != '\t') || tail.size() < 2) return false;
    std::string_view words = tail.substr(1);
    return words.front() != ' ' && equalsIgnoreCase(takeWord(words), word);
  });
  const std::string_view first = trim(text.substr(0, place));
  text = place == std::string_view::npos ? std::string_view{} : trim(text.substr(place));
  takeWord(text);
  return first;
}

}  // namespace

bool Serial::parse(const StepLine& line) {
  std::string_view rest = line.rest();
  const std::string_view name = takeWord(rest), verb = takeWord(rest);
  port = name;
  portPosition = line.at(name);
  const auto* row = std::ranges::find_if(
      kVerbs, [verb](const auto& one) { return equalsIgnoreCase(one.first, verb); });
  if (row == std::end(kVerbs))
    return line.fail(ProblemCode::P0952, verb.empty() ? line.rest() : verb, kVerbNames);
  does = row->second;
  switch (does) {
    case Does::Send:
      return parseCharacters(line, rest, bytes);
    case Does::Answer:
    case Does::NoAnswers:
      return parseAnswer(line, rest);
    case Does::Partner:
      return parsePartner(line, rest);
    case Does::JobSend:
    case Does::JobFetch:
      return parseJob(line, rest);
    case Does::Memory:
      return parseMemory(line, rest);
    case Does::Cut:
    case Does::Connect:
    case Does::Swap:
    case Does::Straight:
    case Does::Noise:
      return parseEnd(line, rest);
    case Does::Disturb:
      return parseDisturb(line, rest);
    case Does::Forget:
      return rest.empty() || line.fail(ProblemCode::P0959, rest, rest, "forget");
  }
  return false;
}

// BYTES with BYTES [after 5ms]; off
bool Serial::parseAnswer(const StepLine& line, std::string_view text) {
  if (equalsIgnoreCase(text, "off")) {
    does = Does::NoAnswers;
    return true;
  }
  const std::string_view whole = text;
  const std::string_view wanted = before(text, "with");
  if (text.empty()) return line.fail(ProblemCode::P0952, whole, "BYTES with BYTES, or off");
  const std::string_view reply = before(text, "after");
  if (!text.empty()) {
    const auto delay = parseDuration(text);
    if (!delay) return line.fail(ProblemCode::P0953, text, text);
    after = *delay;
  }
  return parseCharacters(line, wanted, bytes) && parseCharacters(line, reply, answer);
}

// characters | 3964 | 3964R | RK512, then low or high, a rate, a frame
bool Serial::parsePartner(const StepLine& line, std::string_view text) {
  using Speaks = serial::Partner::Speaks;
  constexpr std::pair<std::string_view, Speaks> kProtocols[] = {{"characters", Speaks::Characters},
                                                                {"3964", Speaks::Procedure},
                                                                {"3964R", Speaks::Procedure},
                                                                {"RK512", Speaks::ComputerLink}};
  const std::string_view protocol = takeWord(text);
  const auto* row = std::ranges::find_if(
      kProtocols, [&](const auto& one) { return equalsIgnoreCase(one.first, protocol); });
  if (row == std::end(kProtocols))
    return line.fail(ProblemCode::P0952, protocol.empty() ? line.rest() : protocol,
                     "characters, 3964, 3964R or RK512");
  speaks = row->second;
  blockCheck = row->first != "3964";
  while (!text.empty()) {
    const std::string_view word = takeWord(text);
    if (equalsIgnoreCase(word, "low") || equalsIgnoreCase(word, "high"))
      highPriority = equalsIgnoreCase(word, "high");
    else if (const auto bits = frameOf(word))
      frame = bits;
    else if (const auto rate = numberOf(word); rate && *rate >= 50 && *rate <= 1'000'000)
      baud = rate;
    else
      return line.fail(ProblemCode::P0952, word, "low, high, a rate (9600) or a frame (8E1)");
  }
  return true;
}

// send AREA BYTES [flag 100.6] | fetch AREA count 4 [flag 100.6]
bool Serial::parseJob(const StepLine& line, std::string_view text) {
  const std::string_view what = takeWord(text), place = takeWord(text);
  const bool fetch = equalsIgnoreCase(what, "fetch");
  const auto area = parseArea(place);
  if ((!fetch && !equalsIgnoreCase(what, "send")) || !area)
    return line.fail(ProblemCode::P0952, place.empty() ? line.rest() : place,
                     "send DB10.DBB0 BYTES, or fetch DB10.DBB0 count 4 (also MB, EB, AB, T, Z)");
  job = *area;
  job.fetch = fetch;
  does = fetch ? Does::JobFetch : Does::JobSend;
  std::string_view content = before(text, "flag");
  if (!text.empty()) {
    const auto point = text.find('.');
    const auto byte = numberOf(text.substr(0, point));
    const auto bit =
        point == std::string_view::npos ? std::nullopt : numberOf(text.substr(point + 1));
    if (!byte || !bit || *byte > 254 || *bit > 7)
      return line.fail(ProblemCode::P0952, text, "a coordination flag: flag 100.6");
    job.flag = {static_cast<std::uint8_t>(*byte), static_cast<std::uint8_t>(*bit)};
  }
  if (!fetch) {
    if (!parseCharacters(line, content, bytes)) return false;
    job.length = static_cast<std::uint16_t>(bytes.size());
  } else {
    const bool counts = equalsIgnoreCase(takeWord(content), "count");
    const auto count = numberOf(content);
    if (!counts || !count || *count < 1 || *count > 1024)
      return line.fail(ProblemCode::P0952, content.empty() ? line.rest() : content,
                       "count 1 to 1024");
    job.length = static_cast<std::uint16_t>(*count);
  }
  return job.length <= 1024 || line.fail(ProblemCode::P0952, content, "at most 1024 bytes");
}

// DB10.DBB0 = BYTES
bool Serial::parseMemory(const StepLine& line, std::string_view text) {
  const std::string_view place = takeWord(text), relation = takeWord(text);
  const auto area = parseArea(place);
  if (!area || relation != "=")
    return line.fail(ProblemCode::P0952, place.empty() ? line.rest() : place, "DB10.DBB0 = BYTES");
  job = *area;
  return parseCharacters(line, text, bytes);
}

// [at partner]
bool Serial::parseEnd(const StepLine& line, std::string_view text) {
  if (text.empty()) return true;
  std::string_view rest = text;
  if (!equalsIgnoreCase(takeWord(rest), "at") || !equalsIgnoreCase(rest, "partner"))
    return line.fail(ProblemCode::P0952, text, "at partner, or nothing");
  end = End::Partner;
  return true;
}

// KIND [BYTE or TIME] [character N] [of X27]
bool Serial::parseDisturb(const StepLine& line, std::string_view text) {
  const std::string_view kind = takeWord(text);
  const auto* row = std::ranges::find_if(
      kDisturbances, [kind](const auto& one) { return equalsIgnoreCase(one.first, kind); });
  if (row == std::end(kDisturbances))
    return line.fail(ProblemCode::P0952, kind.empty() ? line.rest() : kind,
                     "drop, duplicate, flip, replace, insert, parity, stop, overrun or delay");
  fault.kind = row->second;
  end = End::Partner;
  constexpr std::uint16_t kFirstDataBit = 2;
  fault.pattern = kFirstDataBit;
  using Kind = serial::Fault::Kind;
  const bool takes = fault.kind == Kind::Replace || fault.kind == Kind::Insert;
  bool missing = takes || fault.kind == Kind::Delay;
  const auto fails = [&](std::string_view word) {
    return line.fail(ProblemCode::P0952, word.empty() ? line.rest() : word,
                     "character N, of X27, a character to put there, or a time");
  };
  while (!text.empty()) {
    const std::string_view word = takeWord(text);
    if (equalsIgnoreCase(word, "character")) {
      if (!line.number(takeWord(text), character)) return false;
      if (character == 0) return fails(word);
    } else if (equalsIgnoreCase(word, "of")) {
      if (!equalsIgnoreCase(takeWord(text), port)) return fails(word);
      end = End::Cpu;
    } else if (fault.kind == Kind::Delay) {
      const auto delay = parseDuration(word);
      if (!delay) return line.fail(ProblemCode::P0953, word, word);
      fault.delay = *delay;
      missing = false;
    } else {
      serial::Bytes one;
      if (!takes || !parseCharacters(line, word, one) || one.size() != 1) return fails(word);
      fault.pattern = one[0];
      missing = false;
    }
  }
  if (!missing) return true;
  return line.fail(ProblemCode::P0952, kind, takes ? "replace 41, insert 41" : "delay 5ms");
}

bool hasSerialPort(const StepBinding& binding, const std::string& port, const Position& position) {
  const io::Module* module = binding.hardware == nullptr ? nullptr : binding.hardware->find(port);
  if (module != nullptr && module->type->kind == ModuleKind::PointToPoint) return true;
  binding.problems.add(ProblemCode::P0993, position);
  return false;
}

serial::Coupling* couplingOf(controller::Controller& plc) {
  auto* port = controller::capability<serial::SerialPort>(plc);
  return port == nullptr ? nullptr : port->serial();
}

void Serial::resolve(const StepBinding& binding) { hasSerialPort(binding, port, portPosition); }

// A partner has the other priority (PTP-PARAM-27) and otherwise the values of the CPU.
void Serial::speak(serial::Coupling& coupling, Instant now) const {
  serial::Settings settings = coupling.partnerSettings();
  settings.baud = baud.value_or(settings.baud);
  settings.frame = frame.value_or(settings.frame);
  coupling.setPartner(settings, now);
  serial::ProcedureParameters procedure = coupling.parameters().procedure;
  procedure.highPriority = highPriority.value_or(!procedure.highPriority);
  procedure.blockCheck = blockCheck;
  procedure.mask = settings.frame.mask();
  procedure.preparation = {};
  coupling.partner().speak(speaks, procedure, now);
}

bool Serial::begin(StepRun& run, serial::Coupling& coupling) const {
  if (coupling.partner().speaks() != serial::Partner::Speaks::ComputerLink)
    return run.fail("the partner needs RK 512: serial X27 partner RK512");
  return coupling.partner().begin(job, bytes, run.plc().now()) ||
         run.fail("the partner has a job already");
}

bool Serial::act(StepRun& run, serial::Coupling& coupling) const {
  if (coupling.joined() && ofPartner(does)) return run.fail("X27 is connected to another station");
  const Instant now = run.plc().now();
  const bool sends = does == Does::Send || does == Does::Answer;
  if (sends && coupling.partner().speaks() == serial::Partner::Speaks::ComputerLink)
    return run.fail(
        "a partner RK 512 has jobs only: serial X27 job; partner 3964R sends telegrams");
  switch (does) {
    case Does::Send:
      return coupling.partner().send(bytes, now) || run.fail("too much waits to be sent");
    case Does::Answer:
      return coupling.partner().answer({bytes, answer, after}) || run.fail("too many answers");
    case Does::NoAnswers:
      return coupling.partner().forgetRules(), true;
    case Does::Partner:
      return speak(coupling, now), true;
    case Does::JobSend:
    case Does::JobFetch:
      return begin(run, coupling);
    case Does::Memory:
      return coupling.partner().memory().set(
                 job.type, job.block,
                 job.type == 'T' || job.type == 'Z' ? 2U * job.offset : job.offset, bytes) ||
             run.fail("the area ends before");
    case Does::Cut:
    case Does::Connect:
      return coupling.cut(end, does == Does::Cut, now), true;
    case Does::Swap:
    case Does::Straight:
      return coupling.swapPolarity(end, does == Does::Swap, now), true;
    case Does::Noise:
      return coupling.noise(end, 0x00A, now), true;
    case Does::Disturb:
      return coupling.disturb(end, character - 1, fault), true;
    case Does::Forget:
      return coupling.partner().forget(), true;
  }
  return false;
}

bool Serial::perform(StepRun& run) const {
  if (run.need<serial::SerialPort>() == nullptr) return false;
  serial::Coupling* const coupling = couplingOf(run.plc());
  if (coupling == nullptr) return run.lacks(serial::SerialPort::kName);
  if (!act(run, *coupling)) return false;
  coupling->advance(run.plc().now());
  return true;
}

}  // namespace merker::simulator::steps
