#include "positioning/digital_drive.h"

#include <array>

namespace merker::positioning {
namespace {

constexpr std::uint8_t Q0 = 1, Q1 = 2, Q2 = 4, Q3 = 8;

// A row for each control type (POS-DIGCTRL-02 to -05).
struct Pattern {
  std::uint8_t rapidPlus, rapidMinus, creepPlus, creepMinus, reached;
};
constexpr std::array<Pattern, 4> kPatterns{{
    {Q0 | Q2, Q0 | Q3, Q1 | Q2, Q1 | Q3, 0},
    {Q0 | Q2, Q0 | Q3, Q2, Q3, Q1},
    {Q0 | Q1 | Q2, Q0 | Q1 | Q3, Q1 | Q2, Q1 | Q3, 0},
    {Q0 | Q1, Q2 | Q3, Q1, Q3, 0},
}};

}  // namespace

void DigitalDrive::start(int direction, const Motion& motion) {
  direction_ = direction;
  rapid_ = motion.rapid;
  const Differences& differences = motion.differences.of(direction);
  creepWay_ = std::int64_t{differences.changeover} - differences.cutOff;
}

bool DigitalDrive::travel(const Ahead& ahead) {
  stage_ = rapid_ && ahead.changeover > 0 ? Stage::Rapid : Stage::Creep;
  return false;
}

// As a target would be approached: creep for the way from changeover to cut-off point, nothing of
// it if the run creeps anyway (POS-END-04).
bool DigitalDrive::rampDown(std::int64_t travelled) {
  const bool stands = stage_ == Stage::Off || !rapid_ || travelled >= creepWay_;
  stage_ = stands ? Stage::Off : Stage::Creep;
  return stands;
}

Outputs DigitalDrive::outputs(bool positionReached) const {
  const Pattern& pattern = kPatterns[control_ - 1u];
  const bool plus = direction_ > 0;
  Outputs outputs;
  switch (stage_) {
    case Stage::Off:
      outputs.digital = positionReached ? pattern.reached : std::uint8_t{0};
      break;
    case Stage::Creep:
      outputs.digital = plus ? pattern.creepPlus : pattern.creepMinus;
      break;
    case Stage::Rapid:
      outputs.digital = plus ? pattern.rapidPlus : pattern.rapidMinus;
      break;
  }
  return outputs;
}

}  // namespace merker::positioning
