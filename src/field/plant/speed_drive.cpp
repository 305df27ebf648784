// A drive at a bus that keeps a speed: standard telegram 1 of PROFIdrive, application class 1.
#include <cmath>

#include "plant/drive.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "plant/telegram.h"

namespace merker::plant {
namespace {

using Side = Signal::Side;

constexpr auto kParameters = driveParameters(0);
constexpr Signal kSignals[] = {
    {"BUS", Side::Input, true, 1},
    {"STW1", Side::Input},
    {"NSOLL_A", Side::Input},
    {"BLOCKED", Side::Input, true},
    {"EXTERNAL", Side::Input, true},
    {"ZSW1", Side::Output},
    {"NIST_A", Side::Output},
    {"STATE", Side::Output},
    {"FAULT", Side::Output},
    {"POSITION", Side::Output, false, 0, 0, 100'000, "LU"},
    {"LOW_SWITCH", Side::Output, true},
    {"HIGH_SWITCH", Side::Output, true},
    {"SPEED", Side::Output, false, 0, 0, 100'000, "LU/s"},
};

// Bits of the words that only a drive with this telegram has.
constexpr std::uint16_t kEnableRamp = 1 << 4, kUnfreezeRamp = 1 << 5, kEnableSetpoint = 1 << 6;
constexpr std::uint16_t kSpeedReached = 1 << 10;  // of ZSW1: the reference speed
constexpr double kHundredPercent = 0x4000;        // N2

class SpeedDrive : public ProcessOf<kParameters, kSignals> {
 public:
  explicit SpeedDrive(Parameters p) : drive_(driveSettings(p)) {}

  void begin(Signals values) override { show(Instant{}, values); }

  void advance(Instant, Instant to, Signals values) override {
    const bool master = values["BUS"] != 0;
    const auto stw1 = static_cast<std::uint16_t>(std::llround(values["STW1"]));
    if (master && has(stw1, Stw1::ControlByPlc)) {
      control_ = stw1;
      setpoint_ = values["NSOLL_A"] / kHundredPercent * drive_.settings().speed;
    }
    drive_.observe(to, control_, {master, values["BLOCKED"] != 0, values["EXTERNAL"] != 0});
    if (!drive_.operates() || (control_ & kUnfreezeRamp) != 0) frozen_ = false;
    drive_.move(to, wanted(to));
    show(to, values);
  }

 private:
  Drive::Order wanted(Instant now) {
    const DriveSettings& s = drive_.settings();
    if ((control_ & kEnableRamp) == 0) return Drive::toSpeed(0, s.quickStop);
    if ((control_ & kUnfreezeRamp) == 0) {  // the speed that it has
      if (!frozen_) held_ = drive_.motion().speed(now);
      frozen_ = true;
      return Drive::toSpeed(held_, s.acceleration);
    }
    return Drive::toSpeed((control_ & kEnableSetpoint) != 0 ? setpoint_ : 0, s.acceleration);
  }

  void show(Instant now, Signals values) const {
    const double share = drive_.motion().speed(now) / drive_.settings().speed;
    const DriveStates& states = drive_.states();
    values["ZSW1"] = states.statusBits() | bitIf(values["BLOCKED"] == 0, Zsw1::NoDeviation) |
                     (std::abs(share) >= 1 ? kSpeedReached : 0);
    values["NIST_A"] = static_cast<double>(std::llround(share * kHundredPercent));
    showDrive(drive_, now, values);
  }

  Drive drive_;
  std::uint16_t control_ = 0;  // as last taken over
  double setpoint_ = 0;        // the same
  bool frozen_ = false;
  double held_ = 0;
};

}  // namespace

const Kind kSpeedDrive{"speed drive", Duration::milliseconds(1), kParameters,
                       kSignals,      make<SpeedDrive>,          &kTelegram1};

}  // namespace merker::plant
