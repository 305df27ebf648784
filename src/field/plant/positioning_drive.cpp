// A drive at a bus that travels to positions: standard telegram 9 of PROFIdrive (S7-NET-22).
#include <algorithm>
#include <array>
#include <cmath>

#include "plant/named.h"
#include "plant/positioner.h"
#include "plant/processes.h"
#include "plant/telegram.h"

namespace merker::plant {
namespace {

using Form = Parameter::Form;
using Side = Signal::Side;

constexpr Parameter kOwnParameters[] = {
    {"homing_speed", Form::Number, 20'000, 1, 1e9},
    {"jog_speed", Form::Number, 5000, 1, 1e9},
    {"reference", Form::Number, 0, -1e9, 1e9},
    {"home", Form::Number, 0, -1e9, 1e9},
    {"absolute", Form::Flag, 0, 0, 1},
};
constexpr auto kParameters = [] {
  constexpr auto common = driveParameters(50'000);
  std::array<Parameter, common.size() + std::size(kOwnParameters)> all{};
  std::ranges::copy(kOwnParameters, std::ranges::copy(common, all.begin()).out);
  return all;
}();
constexpr Signal kSignals[] = {
    {"BUS", Side::Input, true, 1},
    {"STW1", Side::Input},
    {"SATZANW", Side::Input},
    {"MDI_TARPOS", Side::Input, false, 0, 0, 100'000, "LU"},
    {"MDI_VELOCITY", Side::Input},
    {"MDI_ACC", Side::Input},
    {"MDI_DEC", Side::Input},
    {"MDI_MOD", Side::Input},
    {"BLOCKED", Side::Input, true},
    {"EXTERNAL", Side::Input, true},
    {"ZSW1", Side::Output},
    {"AKTSATZ", Side::Output},
    {"XIST_A", Side::Output, false, 0, 0, 100'000, "LU"},
    {"STATE", Side::Output},
    {"FAULT", Side::Output},
    {"WARNING", Side::Output},
    {"POSITION", Side::Output, false, 0, 0, 100'000, "LU"},
    {"SPEED", Side::Output, false, 0, 0, 100'000, "LU/s"},
    {"LOW_SWITCH", Side::Output, true},
    {"HIGH_SWITCH", Side::Output, true},
    {"CAM", Side::Output, true},
};

std::uint16_t wordOf(double value) { return static_cast<std::uint16_t>(std::llround(value)); }

class PositioningDrive : public ProcessOf<kParameters, kSignals> {
 public:
  explicit PositioningDrive(Parameters p)
      : drive_(driveSettings(p)),
        positioner_(
            {p["homing_speed"], p["jog_speed"], p["reference"], p["home"], p["absolute"] != 0},
            drive_) {}

  void begin(Signals values) override { show(Instant{}, values); }

  void advance(Instant, Instant to, Signals values) override {
    const bool master = values["BUS"] != 0;
    if (master && has(wordOf(values["STW1"]), Stw1::ControlByPlc)) take(values);
    drive_.observe(to, control_, {master, values["BLOCKED"] != 0, values["EXTERNAL"] != 0});
    drive_.move(to, positioner_.wanted(to, setpoints_));
    show(to, values);
  }

 private:
  void take(Signals values) {
    control_ = wordOf(values["STW1"]);
    setpoints_ = {.satzanw = wordOf(values["SATZANW"]),
                  .mode = wordOf(values["MDI_MOD"]),
                  .target = values["MDI_TARPOS"],
                  .velocity = values["MDI_VELOCITY"],
                  .acceleration = values["MDI_ACC"],
                  .deceleration = values["MDI_DEC"]};
  }

  void show(Instant now, Signals values) const {
    const DriveStates& states = drive_.states();
    values["ZSW1"] = states.statusBits() | bitIf(values["BLOCKED"] == 0, Zsw1::NoDeviation) |
                     positioner_.statusBits(now);
    values["AKTSATZ"] = positioner_.currentBlock();
    values["XIST_A"] = static_cast<double>(std::llround(positioner_.position(now)));
    values["WARNING"] = states.warning();
    showDrive(drive_, now, values);
    values["CAM"] = positioner_.onCam(now);
  }

  Drive drive_;
  Positioner positioner_;
  std::uint16_t control_ = 0;  // as last taken over
  PositionerSetpoints setpoints_;
};

}  // namespace

const Kind kPositioningDrive{
    "positioning drive", Duration::milliseconds(1), kParameters, kSignals, make<PositioningDrive>,
    &kTelegram9};

}  // namespace merker::plant
