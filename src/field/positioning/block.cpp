#include "positioning/block.h"

#include <utility>

#include "positioning/error.h"

namespace merker::positioning {
namespace {

bool isJog(const Command& command) { return command.mode == static_cast<std::int32_t>(Mode::Jog); }

bool misused(std::uint16_t status) { return (status & 0xFF00) == (kWrongChannel & 0xFF00); }

}  // namespace

void Block::setStatus(std::uint16_t status) {
  answer_.status = status;
  answer_.error = status != kNoError;
}

// The number names the block that is to be called (POS-OPEN-04).
std::uint16_t Block::misuse(const Channel& channel, const Command& command) const {
  if (channel.parameters().output != kind_)
    return kind_ == io::AxisOutput::Analog ? kUseDigitalBlock : kUseAnalogBlock;
  return command.channel != 0 ? kWrongChannel : kNoError;
}

bool Block::call(Channel& channel, const Command& command) {
  const std::uint16_t misuse = this->misuse(channel, command);
  if (misuse != kNoError || misused(answer_.status)) setStatus(misuse);
  if (misuse != kNoError) return false;
  if (command.acknowledge && !last_.acknowledge) channel.acknowledge();
  const bool jobFailed = runJob(channel, command);
  channel.control(command.driveEnable, command.stop);
  runStarts(channel, command, jobFailed);
  channel.selectMode(command.mode);
  last_ = command;
  called_ = true;
  return true;
}

// JOB_DONE is FALSE for one call (POS-JOB-03); true: a job has just failed.
bool Block::runJob(Channel& channel, const Command& command) {
  answer_.jobDone = true;
  if (!command.jobRequest || last_.jobRequest) return false;
  answer_.jobDone = false;
  answer_.jobStatus = channel.job(command.job, command.jobValue);
  answer_.jobError = answer_.jobStatus != kNoError;
  return answer_.jobError;
}

// Directions that change while a jog run has lost its mode count when it is back.
void Block::runStarts(Channel& channel, const Command& command, bool jobFailed) {
  const Request request{command.mode,   command.start,  command.plus, command.minus,
                        command.target, command.motion, jobFailed};
  const bool rises = (command.start && !last_.start) || (command.plus && !last_.plus) ||
                     (command.minus && !last_.minus);
  const bool changed = called_ && command.mode != last_.mode &&
                       command.mode != static_cast<std::int32_t>(channel.mode());
  const bool refused = channel.working() && changed && !rises;
  const bool jogging = channel.working() && channel.mode() == Mode::Jog;
  if (isJog(command) || !jogging) {
    const bool plus = std::exchange(jogPlus_, command.plus) != command.plus;
    const bool minus = std::exchange(jogMinus_, command.minus) != command.minus;
    if (isJog(command)) jog(channel, request, plus || minus, command.start && !last_.start);
  }
  if (!isJog(command) && rises) setStatus(channel.begin(request));
  if (refused) setStatus(kModeChanged);
}

// Levels of the two directions that changed (POS-JOG-02).
void Block::jog(Channel& channel, const Request& request, bool changed, bool starts) {
  const bool single = request.plus != request.minus;
  if (changed && !single) channel.endJog();
  if (!(changed && single) && !starts) return;
  setStatus(channel.begin(request));
  if (answer_.error && changed) channel.endJog();
}

}  // namespace merker::positioning
