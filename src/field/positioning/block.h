// A call of SFB 44 ANALOG or SFB 46 DIGITAL: what the block remembers from call to call, and the
// order of its work (technology manual 3.4.2, 3.4.8; POS-RUN-37).
#pragma once

#include <optional>

#include "positioning/channel.h"

namespace merker::positioning {

// The inputs of a block.
struct Command {
  std::int32_t channel = 0;
  bool driveEnable = false, start = false, plus = false, minus = false, stop = false;
  bool acknowledge = false;
  std::int32_t mode = 1, target = 1000;
  Motion motion;
  bool jobRequest = false;
  std::int32_t job = 0, jobValue = 0;
};

// What it shows beside the image of the axis.
struct Answer {
  bool error = false;
  std::uint16_t status = 0;
  bool jobDone = true, jobError = false;
  std::uint16_t jobStatus = 0;
};

// One for each instance data block; the axis itself is in the channel (POS-OPEN-28, POS-OPEN-29).
class Block {
 public:
  explicit Block(io::AxisOutput kind) : kind_(kind) {}

  // False: the wrong block or channel; only error and status change (POS-ERR-06 to -08).
  bool call(Channel& channel, const Command& command);
  const Answer& answer() const { return answer_; }

 private:
  std::uint16_t misuse(const Channel& channel, const Command& command) const;
  bool runJob(Channel& channel, const Command& command);
  void runStarts(Channel& channel, const Command& command, bool jobFailed);
  void jog(Channel& channel, const Request& request, bool changed, bool starts);
  void setStatus(std::uint16_t status);

  io::AxisOutput kind_;
  Answer answer_;
  Command last_;                             // of the call before: its levels
  bool jogPlus_ = false, jogMinus_ = false;  // as last evaluated
  bool called_ = false;
};

}  // namespace merker::positioning
