// The positioning channel of a compact CPU: encoder, switches and set-point between the terminals
// and SFB 44 or SFB 46 (technology manual, chapters 3 and 4). It is moved by its cycle of 4 ms;
// what happens at fast inputs in between is told in the order of time.
#pragma once

#include <memory>
#include <optional>

#include "positioning/arrival.h"
#include "positioning/length.h"
#include "positioning/movement.h"
#include "positioning/position.h"
#include "positioning/run.h"
#include "positioning/start.h"

namespace merker::positioning {

// What the blocks show of the axis: as of the last cycle, and what calls have changed since then.
struct Image {
  bool working = false, positionReached = false, measured = false, synchronous = false;
  bool startEnabled = false, parametrised = false, down = false;
  bool cutOff = false, changedOver = false, rampDown = false, rampUp = false;
  Mode mode = Mode::None;
  std::uint16_t errors = 0;
  std::int32_t position = 0, distanceToGo = 0, lastTarget = 0;
  std::int32_t measureBegin = 0, measureEnd = 0, length = 0;
};

class Channel {
 public:
  explicit Channel(const io::AxisChannel& parameters);

  // Whether the parameters count (POS-PARAM-29); what does not fit together never does.
  void parametrise(bool sound);
  void start();  // the CPU: STOP to RUN (POS-RUN-33)
  void stop();   // RUN to STOP (POS-END-08)

  // At the inputs.
  void move(std::int64_t pulses);  // of the encoder, all in one direction
  void zeroMark();
  void referenceSwitch(bool on);
  void lengthInput(bool on) { lengthInput(on, position()); }
  void lengthInput(bool on, std::int64_t position);  // where the edge was

  void cycle();
  const Outputs& outputs() const { return outputs_; }  // they change in cycles only
  std::int32_t analogValue() const;                    // of AO 0 (POS-RUN-19)

  // By a block.
  void control(bool driveEnabled, bool stop);  // DRV_EN, STOP
  void acknowledge();                          // ERR_A
  std::uint16_t job(std::int32_t id, std::int32_t value);
  std::uint16_t begin(const Request& request);
  void endJog();  // neither direction is wanted any more
  void selectMode(std::int32_t mode);

  const io::AxisChannel& parameters() const { return p_; }
  bool working() const { return run_.has_value(); }
  Mode mode() const { return mode_; }
  std::uint16_t errors() const { return errors_; }
  std::int64_t position() const { return position_.now(); }  // now, not of the last cycle
  Image image() const;

 private:
  void watchLimits();
  void stepRun();
  void endRun(Run::Progress how);
  void show() { outputs_ = drive_->outputs(arrival_.reached()); }
  void trip(std::uint16_t errors);
  void abort();
  Situation situation() const;
  void execute(const Plan& plan);
  std::uint16_t setReference(std::int32_t value);
  void deleteDistance();

  io::AxisChannel p_;
  bool fits_, parametrised_;
  std::unique_ptr<Drive> drive_;
  Position position_;
  Length length_;
  Arrival arrival_;
  Movement movement_;
  std::optional<Run> run_;
  std::optional<Interrupted> interrupted_;
  Outputs outputs_;

  Mode mode_ = Mode::None;
  bool driveEnabled_ = false, stopped_ = false;  // DRV_EN and STOP of the last call
  bool referenceSwitch_ = false, lengthInput_ = false;
  bool synchronous_ = false;
  bool cutOff_ = false, changedOver_ = false;
  std::uint16_t errors_ = 0;
  bool missingPulse_ = false;  // since the last cycle
  std::int64_t seen_ = 0;      // position in the last cycle
  std::int64_t lastTarget_ = 0;
  bool insideLimits_ = true, insideTravel_ = true;  // in the last cycle
};

}  // namespace merker::positioning
