// A CPU with a counting sub-module whose channels the test parametrises, and one call of SFB 47, 48
// or 49 in its OB 1.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "program.h"
#include "signal/pulse_train.h"

namespace merker::station::test {

using io::CountChannel;
using io::CountMode;

inline CountChannel channel(CountMode mode) {
  CountChannel c;
  c.mode = mode;
  c.maxFrequency = c.latchFrequency = 1;
  c.highLimit = 10'000'000;
  return c;
}

// The sub-module with these channels, DB 9 as the instance of OB 1's call, which M 100.0 = 1 skips.
class Counting {
 public:
  using Change = std::function<void(io::Parameters&, io::Module&)>;
  explicit Counting(int sfb, const Change& change, std::string_view more = {},
                    const CpuModel& model = defaultCpuModel())
      : plc(text(sfb, more), model, hardware(model, change)) {
    plc.start();
    plc->advanceCycles(1);
  }
  void pulses(std::uint32_t input, std::int64_t count, std::int64_t hertz = 100,
              std::int64_t delay = 0) {
    signal::Pulses p =
        signal::pulsesOf(hertz * 1000, 500, plc->now() + Duration::milliseconds(delay));
    p.count = count;
    plc->rack()->attach(*plc->rack()->terminal("2.2", io::Side::DigitalInput, input),
                        std::make_shared<signal::PulseTrain>(p), plc->now());
  }
  void input(std::uint32_t number, bool level) {
    plc->rack()->setLevel(*plc->rack()->terminal("2.2", io::Side::DigitalInput, number), level,
                          plc->now());
  }
  bool output(std::uint32_t number) {
    return plc->rack()->level(*plc->rack()->terminal("2.2", io::Side::DigitalOutput, number));
  }
  void wait(std::int64_t ms) { plc.run(Duration::milliseconds(ms)); }
  std::uint32_t read(std::string_view name) { return plc.read("DB9." + std::string(name)); }
  void set(std::string_view name, std::uint32_t value) {
    plc.write("DB9." + std::string(name), value);
  }
  // What the next call says.
  std::uint32_t status() {
    plc->advanceCycles(1);
    return plc.read("M 0.0") != 0 ? 0 : read("JOB_STAT");
  }

  Plc plc;

 private:
  static std::string text(int sfb, std::string_view more) {
    return "DATA_BLOCK DB 9 SFB " + std::to_string(sfb) + "\nBEGIN\nEND_DATA_BLOCK\n" +
           std::string(more) +
           ob(1, "U M 100.0; SPB ende; CALL SFB " + std::to_string(sfb) +
                     ", DB 9; U BIE; = M 0.0; ende: NOP 0;");
  }
  static io::Configuration hardware(const CpuModel& model, const Change& change) {
    io::Module counting;
    counting.type = onBoardType(model, 4);
    counting.slot = 2;
    counting.subslot = 4;
    counting.parameters = io::Parameters::of(*counting.type);
    change(counting.parameters, counting);
    Problems problems;
    return io::configure({counting}, model, problems);
  }
};

}  // namespace merker::station::test
