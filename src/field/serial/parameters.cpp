#include "serial/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace merker::serial {
namespace {

struct Rate {
  std::uint32_t baud;
  std::int64_t ascii, procedure;  // shortest times in ms
};
constexpr std::array<Rate, 8> kRates{{{300, 130, 60},
                                      {600, 65, 40},
                                      {1200, 32, 30},
                                      {2400, 16, 20},
                                      {4800, 8, 20},
                                      {9600, 4, 20},
                                      {19200, 2, 20},
                                      {38400, 1, 20}}};

const Rate* rateOf(std::uint32_t baud) {
  const auto* found = std::find_if(kRates.begin(), kRates.end(),
                                   [baud](const Rate& rate) { return rate.baud == baud; });
  return found == kRates.end() ? nullptr : found;
}

struct Grid {
  std::int64_t step, most;  // ms
};
Grid gridOf(Protocol protocol) {
  return protocol == Protocol::Ascii ? Grid{1, 65'535} : Grid{10, 65'530};
}

class Checker {
 public:
  explicit Checker(const Parameters& parameters) : p_(parameters) {}
  std::vector<Refusal> run() {
    line();
    if (p_.protocol == Protocol::Ascii) {
      wiring();
      ascii();
    } else {
      procedure();
    }
    if (p_.protocol != Protocol::ComputerLink) mailbox();
    return std::move(refusals_);
  }

 private:
  void refuse(bool wrong, std::string_view parameter, std::string text) {
    if (wrong) refusals_.push_back({parameter, std::move(text)});
  }
  void range(std::int64_t value, std::int64_t least, std::int64_t most,
             std::string_view parameter) {
    refuse(value < least || value > most, parameter,
           fmt::format("{} must be {} to {}", parameter, least, most));
  }
  void time(Duration value, std::int64_t least, Grid grid, std::string_view parameter,
            bool ofRate) {
    const bool wrong = value < Duration::milliseconds(least) ||
                       value > Duration::milliseconds(grid.most) ||
                       value.ns % (grid.step * 1'000'000) != 0;
    refuse(wrong, parameter,
           fmt::format("{} must be {} to {} ms in steps of {} ms{}", parameter, least, grid.most,
                       grid.step, ofRate ? fmt::format(" at {} baud", p_.line.baud) : ""));
  }

  void line() {
    const Frame& frame = p_.line.frame;
    refuse(rateOf(p_.line.baud) == nullptr, "baud",
           "baud must be 300, 600, 1200, 2400, 4800, 9600, 19200 or 38400");
    range(frame.dataBits, 7, 8, "data bits");
    range(frame.stopBits, 1, 2, "stop bits");
    refuse(frame.dataBits == 7 && frame.parity == Parity::None, "parity",
           "7 data bits need a parity");
    refuse(p_.protocol == Protocol::ComputerLink && frame.dataBits != 8, "data bits",
           "RK 512 has 8 data bits");
    refuse(p_.protocol != Protocol::Ascii && p_.line.mode != Mode::PointToPoint, "mode",
           "3964(R) and RK 512 need four wires between two partners (RS 422)");
    refuse(p_.line.mode == Mode::MultipointSlave, "mode", "a CPU is master of a multipoint line");
  }

  void wiring() {
    const bool twoPartners = p_.line.mode == Mode::PointToPoint;
    refuse(!twoPartners && p_.line.preset == Preset::Break, "preset",
           "break recognition needs four wires between two partners (RS 422)");
    refuse(!twoPartners && p_.ascii.flowControl, "flow control",
           "XON/XOFF needs four wires between two partners (RS 422)");
  }

  void character(std::uint8_t value, std::string_view parameter) {
    range(value, 0, p_.line.frame.mask(), parameter);
  }

  void ascii() {
    const AsciiParameters& a = p_.ascii;
    const Rate* rate = rateOf(p_.line.baud);
    const std::int64_t least = rate != nullptr ? rate->ascii : 1;
    time(a.delay, least, gridOf(Protocol::Ascii), "character delay time", least > 1);
    if (a.end == AsciiParameters::End::Count) range(a.length, 1, 1024, "telegram length");
    if (a.end == AsciiParameters::End::Characters) {
      range(a.endCharacters, 1, 2, "number of end characters");
      range(a.checkCharacters, 0, 2, "number of block check characters");
      character(a.end1, "end character 1");
      if (a.endCharacters == 2) character(a.end2, "end character 2");
    }
    if (!a.flowControl) return;
    character(a.xon, "XON");
    character(a.xoff, "XOFF");
    refuse(a.xon == a.xoff, "XOFF", "XON and XOFF must be different characters");
    time(a.xonWait, 20, {10, 65'530}, "waiting time for XON", false);
    if (a.end != AsciiParameters::End::Characters) return;
    const auto steers = [&a](std::uint8_t end) { return end == a.xon || end == a.xoff; };
    refuse(steers(a.end1) || (a.endCharacters == 2 && steers(a.end2)), "end character 1",
           "XON and XOFF cannot be end characters");
  }

  void procedure() {
    const Rate* rate = rateOf(p_.line.baud);
    const std::int64_t least = rate != nullptr ? rate->procedure : 20;
    time(p_.procedure.characterDelay, least, gridOf(p_.protocol), "character delay time", true);
    time(p_.procedure.acknowledgeDelay, least, gridOf(p_.protocol), "acknowledgement delay time",
         true);
    range(p_.procedure.setups, 1, 255, "set-up attempts");
    range(p_.procedure.transmissions, 1, 255, "transmission attempts");
  }

  void mailbox() {
    if (!p_.mailbox.wholeBuffer) range(p_.mailbox.telegrams, 1, 10, "buffered telegrams");
  }

  const Parameters& p_;
  std::vector<Refusal> refusals_;
};

}  // namespace

Preset defaultPreset(Mode mode) {
  return mode == Mode::PointToPoint ? Preset::Break : Preset::Idle;
}

Duration defaultAcknowledgeDelay(bool blockCheck) {
  return blockCheck ? Duration::milliseconds(2'000) : kDelayWithoutBlockCheck;
}

Parameters defaults(Protocol protocol) {
  Parameters parameters;
  parameters.protocol = protocol;
  return parameters;
}

Duration leastCharacterDelay(Protocol protocol, std::uint32_t baud) {
  const Rate* rate = rateOf(baud);
  if (rate == nullptr) return {};
  return Duration::milliseconds(protocol == Protocol::Ascii ? rate->ascii : rate->procedure);
}

Duration settable(Protocol protocol, std::uint32_t baud, Duration time) {
  const Grid grid = gridOf(protocol);
  const std::int64_t step = grid.step * 1'000'000;
  const Duration rounded{(time.ns + step - 1) / step * step};
  const Duration least = leastCharacterDelay(protocol, baud);
  return std::min(std::max(rounded, least), Duration::milliseconds(grid.most));
}

std::vector<Refusal> check(const Parameters& parameters) { return Checker(parameters).run(); }

}  // namespace merker::serial
