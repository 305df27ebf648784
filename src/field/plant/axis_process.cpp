// The axis as a plant: its drive at the outputs of a CPU, its encoder and switches at the inputs.
// Tracks and switches are known in advance for each step of 4 ms, to the nanosecond.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plant/axis.h"
#include "plant/named.h"
#include "plant/processes.h"
#include "signal/ramp_track.h"

namespace merker::plant {
namespace {

using Form = Parameter::Form;

constexpr double kFar = 500'000'000;  // pulses
constexpr double kFast = 1'000'000;   // pulses/s
constexpr Duration kStep = Duration::milliseconds(4);

constexpr Parameter kParameters[] = {
    {"contactors", Form::Whole, 0, 0, 4},  // control type; 0: the analog output
    {"direction_signal", Form::Flag, 0, 0, 1},
    {"speed", Form::Whole, 10'000, 1, kFast},  // at 10 V or 20 mA
    {"acceleration", Form::Whole, 100'000, 1, 1e8},
    {"rapid", Form::Whole, 10'000, 1, kFast},
    {"creep", Form::Whole, 1000, 1, kFast},
    {"contactor_acceleration", Form::Whole, 20'000, 1, 1e8},
    {"coast", Form::Whole, 5000, 1, 1e8},
    {"load", Form::Number, 1, 0.1, 100},
    {"time_constant", Form::Time, 0, 0, 60},
    {"stiction", Form::Number, 0, 0, 10},  // V
    {"drift", Form::Whole, 0, -kFast, kFast},
    {"increments", Form::Whole, 500, 1, 1 << 23},
    {"zero_mark", Form::Whole, 0, -kFar, kFar},
    {"backlash", Form::Whole, 0, 0, 1e6},
    {"revolution", Form::Whole, 0, 0, 1e9},
    {"reference_from", Form::Whole, 30'300, -kFar, kFar},
    {"reference_to", Form::Whole, 35'300, -kFar, kFar},
    {"workpiece_from", Form::Whole, 1000, -kFar, kFar},
    {"workpiece_to", Form::Whole, 1250, -kFar, kFar},
    {"low_switch", Form::Whole, -20'000, -kFar, kFar},
    {"high_switch", Form::Whole, 320'000, -kFar, kFar},
    {"start", Form::Whole, 0, -kFar, kFar},
    {"swapped", Form::Flag, 0, 0, 1},
};
constexpr Signal kSignals[] = {
    {"SETPOINT", Signal::Side::Input, false, 0, 0, 10, "V"},
    {"ENABLE", Signal::Side::Input, true},
    {"DIRECTION", Signal::Side::Input, true},
    {"Q0", Signal::Side::Input, true},
    {"Q1", Signal::Side::Input, true},
    {"Q2", Signal::Side::Input, true},
    {"Q3", Signal::Side::Input, true},
    {"HAND", Signal::Side::Input, false, 0, -1000, 1000, "1/s"},
    {"BLOCKED", Signal::Side::Input, true},
    {"EMERGENCY_STOP", Signal::Side::Input, true},
    {"SWAPPED", Signal::Side::Input, true},
    {"LOST", Signal::Side::Input, false, 0, 0, 1000},
    {"A", Signal::Side::Output, true},
    {"B", Signal::Side::Output, true},
    {"N", Signal::Side::Output, true},
    {"REFERENCE", Signal::Side::Output, true},
    {"WORKPIECE", Signal::Side::Output, true},
    {"LOW_SWITCH", Signal::Side::Output, true},
    {"HIGH_SWITCH", Signal::Side::Output, true},
    {"POSITION", Signal::Side::Output, false, 0, 0, 100'000},
    {"SPEED", Signal::Side::Output, false, 0, 0, 10'000, "1/s"},
    {"ENCODER", Signal::Side::Output, false, 0, 0, 100'000},
};

using Parameters = Named<kParameters, const double>;

std::int64_t whole(double value) { return std::llround(value); }

// The share of a change that comes through in one step (POS-PLANT-05).
std::int64_t lagOf(double timeConstant) {
  return timeConstant == 0
             ? 0
             : std::max<std::int64_t>(whole(65'536 * (1 - std::exp(-0.004 / timeConstant))), 1);
}

AxisSettings settingsOf(Parameters p) {
  AxisSettings s;
  s.section = p["contactors"] != 0         ? PowerSection::Contactors
              : p["direction_signal"] != 0 ? PowerSection::WithDirection
                                           : PowerSection::Bipolar;
  s.controlType = static_cast<std::uint8_t>(whole(p["contactors"]));
  s.fastest = whole(p["speed"]);
  s.acceleration = whole(p["acceleration"]);
  s.rapid = whole(p["rapid"]);
  s.creep = whole(p["creep"]);
  s.contactorAcceleration = whole(p["contactor_acceleration"]);
  s.coast = whole(p["coast"]);
  s.load = whole(p["load"] * 1000);
  s.lag = lagOf(p["time_constant"]);
  s.stiction = whole(p["stiction"] * 1e9);
  s.drift = whole(p["drift"]);
  s.lowSwitch = whole(p["low_switch"]);
  s.highSwitch = whole(p["high_switch"]);
  s.places.betweenMarks = 4 * whole(p["increments"]);
  s.places.firstMark = whole(p["zero_mark"]);
  s.places.backlash = whole(p["backlash"]);
  s.places.revolution = whole(p["revolution"]);
  s.places.reference = {whole(p["reference_from"]), whole(p["reference_to"])};
  s.places.workpiece = {whole(p["workpiece_from"]), whole(p["workpiece_to"])};
  return s;
}

// In pulses/s, of the same instant as the position: within a step it changes evenly.
double speedAt(const signal::Ramp& ramp, Instant t) {
  const std::int64_t passed = std::clamp<std::int64_t>((t - ramp.start).ns, 0, ramp.length.ns);
  const double share = static_cast<double>(passed) / static_cast<double>(ramp.length.ns);
  const auto speed = static_cast<double>(ramp.speed), last = static_cast<double>(ramp.last);
  return (speed + share * (last - speed)) / 1000;
}

// The tracks say everything.
struct Unheard : AxisObserver {
  void moved(std::int64_t) override {}
  void zeroMark() override {}
  void referenceSwitch(bool) override {}
  void lengthInput(bool) override {}
};

class AxisProcess : public ProcessOf<kParameters, kSignals> {
 public:
  explicit AxisProcess(Parameters parameters)
      : settings_(settingsOf(parameters)),
        axis_(settings_, whole(parameters["start"])),
        swapped_(parameters["swapped"] != 0) {
    follow(Instant{});
  }

  void begin(Signals values) override { show(end_, values); }

  // Inputs act on the step that begins here; in between only the position is new.
  void advance(Instant, Instant to, Signals values) override {
    if (!begun_) end_ = to;
    begun_ = true;
    for (; end_ <= to; end_ = end_ + kStep) step(values);
    show(to, values);
  }

  std::shared_ptr<const signal::Signal> course(std::uint32_t signal) const override {
    const std::uint32_t first = Signals::at("A");
    return signal >= first && signal < first + kCourses ? courses_[signal - first] : nullptr;
  }

 private:
  static constexpr std::size_t kCourses = 5;  // from A to WORKPIECE
  static_assert(areTogether(kSignals, "A", "WORKPIECE", kCourses));
  static_assert(areTogether(kSignals, "Q0", "Q3", 4));

  void step(Signals values) {
    AxisInputs inputs;
    inputs.nanovolts = whole(values["SETPOINT"] * 1e9);
    inputs.enable = values["ENABLE"] != 0;
    inputs.direction = values["DIRECTION"] != 0;
    for (unsigned i = 0; i < 4; ++i)
      if (values.from("Q0")[i] != 0)
        inputs.contactors = static_cast<std::uint8_t>(inputs.contactors | 1u << i);
    axis_.turn(whole(values["HAND"]));
    axis_.faults.blocked = values["BLOCKED"] != 0;
    axis_.faults.emergencyStop = values["EMERGENCY_STOP"] != 0;
    Unheard nobody;
    const bool stood = axis_.ramp().last == 0;
    axis_.step(inputs, nobody);
    const bool faulty = takeFaults(values);
    if (faulty || !stood || axis_.ramp().last != 0 || axis_.ramp().speed != 0) follow(end_);
  }

  // Tracks that are swapped, and pulses that get lost from now on: whole periods of a track. True
  // if something is new.
  bool takeFaults(Signals values) {
    constexpr std::int64_t kPeriod = 4;
    const bool swapped = (values["SWAPPED"] != 0) != swappedSince_;
    if (swapped) swapped_ = !swapped_;
    swappedSince_ = values["SWAPPED"] != 0;
    const std::int64_t wanted = (whole(std::abs(values["LOST"])) + kPeriod - 1) / kPeriod * kPeriod;
    const bool lost = wanted != lost_ && wanted != 0;
    lost_ = wanted;
    if (lost) gap_ = {axis_.ramp().pulseAt(Instant{}), axis_.speed() < 0 ? -wanted : wanted};
    return swapped || lost;
  }

  std::shared_ptr<const signal::Signal> trackOf(signal::RampTrackKind kind,
                                                const signal::ZeroMarks& marks) const {
    if (gap_ && kind != signal::RampTrackKind::N)
      return std::make_shared<signal::LosingTrack>(ramp_, marks, kind, *gap_);
    return std::make_shared<signal::RampTrack>(ramp_, marks, kind);
  }

  static std::shared_ptr<const signal::Ramp> from(Instant now, signal::Ramp ramp) {
    ramp.start = now;
    return std::make_shared<const signal::Ramp>(ramp);
  }

  // The axis takes another course from `now` on.
  void follow(Instant now) {
    ramp_ = from(now, axis_.ramp());
    load_ = settings_.places.backlash == 0 ? ramp_ : from(now, axis_.loadRamp());
    const AxisPlaces& places = settings_.places;
    const signal::ZeroMarks marks{places.betweenMarks, places.firstMark, false};
    using Kind = signal::RampTrackKind;
    courses_[0] = trackOf(swapped_ ? Kind::B : Kind::A, marks);
    courses_[1] = trackOf(swapped_ ? Kind::A : Kind::B, marks);
    courses_[2] = trackOf(Kind::N, marks);
    if (gap_ && !gap_->holds(signal::pulseOf(ramp_->end()))) gap_.reset();  // they are lost once
    const auto zone = [&](const Zone& z) {
      return std::make_shared<signal::RampZone>(load_, z.from, z.to, places.revolution);
    };
    courses_[3] = zone(places.reference);
    courses_[4] = zone(places.workpiece);
  }

  void show(Instant now, Signals values) const {
    const std::int64_t pulse = load_->pulseAt(now);
    for (std::size_t i = 0; i < kCourses; ++i) values.from("A")[i] = courses_[i]->level(now);
    values["LOW_SWITCH"] = pulse < settings_.lowSwitch;
    values["HIGH_SWITCH"] = pulse > settings_.highSwitch;
    values["POSITION"] = static_cast<double>(load_->at(now)) / signal::kPulse;
    values["ENCODER"] = static_cast<double>(ramp_->at(now)) / signal::kPulse;
    values["SPEED"] = speedAt(*ramp_, now);
  }

  AxisSettings settings_;
  Axis axis_;
  bool swapped_, swappedSince_ = false;
  std::int64_t lost_ = 0;  // as last wanted
  std::optional<signal::LosingTrack::Gap> gap_;
  bool begun_ = false;
  Instant end_;                                      // of the present step
  std::shared_ptr<const signal::Ramp> ramp_, load_;  // of the motor, of what it drives
  std::array<std::shared_ptr<const signal::Signal>, kCourses> courses_;
};

}  // namespace

const Kind kAxis{"axis", kStep, kParameters, kSignals, make<AxisProcess>, nullptr, true};

}  // namespace merker::plant
