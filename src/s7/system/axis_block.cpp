// SFB 44 ANALOG and SFB 46 DIGITAL (technology manual 3.4, 3.8.4, 4.4, 4.8.4; POS-IF44, POS-IF46).
#include <fmt/format.h>

#include "positioning/positioning.h"
#include "system/call.h"

namespace merker::system {
namespace {

using positioning::Answer;
using positioning::Command;
using positioning::Image;

std::uint32_t bits(std::int32_t value) { return static_cast<std::uint32_t>(value); }

template <typename A>
void readSwitchingPoints(A& a, positioning::Motion& motion) {
  motion.differences.plus = {a.longInteger("CHGDIFF_P"), a.longInteger("CUTOFFDIFF_P")};
  motion.differences.minus = {a.longInteger("CHGDIFF_M"), a.longInteger("CUTOFFDIFF_M")};
}

void readMotion(Sfb<44>& a, positioning::Motion& motion) {
  motion.speed = a.longInteger("SPEED");
  motion.acceleration = a.longInteger("ACCEL");
  motion.deceleration = a.longInteger("DECEL");
}

void readMotion(Sfb<46>& a, positioning::Motion& motion) { motion.rapid = a.flag("SPEED"); }

template <typename A>
Command read(A& a) {
  Command command;
  command.channel = a.integer("CHANNEL");
  command.driveEnable = a.flag("DRV_EN");
  command.start = a.flag("START");
  command.plus = a.flag("DIR_P");
  command.minus = a.flag("DIR_M");
  command.stop = a.flag("STOP");
  command.acknowledge = a.flag("ERR_A");
  command.mode = a.integer("MODE_IN");
  command.target = a.longInteger("TARGET");
  readMotion(a, command.motion);
  readSwitchingPoints(a, command.motion);
  command.jobRequest = a.flag("JOB_REQ");
  command.job = a.integer("JOB_ID");
  command.jobValue = a.longInteger("JOB_VAL");
  return command;
}

void showRamps(Sfb<44>& a, const Image& image) {
  a.set("RAMP_DN", image.rampDown);
  a.set("RAMP_UP", image.rampUp);
}

void showRamps(Sfb<46>&, const Image&) {}

template <typename A>
void show(A& a, const Image& image) {
  a.set("WORKING", image.working);
  a.set("POS_RCD", image.positionReached);
  a.set("MSR_DONE", image.measured);
  a.set("SYNC", image.synchronous);
  a.set("ACT_POS", bits(image.position));
  a.set("MODE_OUT", static_cast<std::uint32_t>(image.mode));
  a.set("ERR", image.errors);
  a.set("ST_ENBLD", image.startEnabled);
  a.set("PARA", image.parametrised);
  a.set("DIR", image.down);
  a.set("CUTOFF", image.cutOff);
  a.set("CHGOVER", image.changedOver);
  showRamps(a, image);
  a.set("DIST_TO_GO", bits(image.distanceToGo));
  a.set("LAST_TRG", bits(image.lastTarget));
  a.set("BEG_VAL", bits(image.measureBegin));
  a.set("END_VAL", bits(image.measureEnd));
  a.set("LEN_VAL", bits(image.length));
}

template <typename A>
void show(A& a, const Answer& answer) {
  a.set("JOB_DONE", answer.jobDone);
  a.set("JOB_ERR", answer.jobError);
  a.set("JOB_STAT", answer.jobStatus);
}

// A system error has no number: BIE, and where the cause is not in the data block an entry in the
// diagnostic buffer (POS-ERR-02, POS-OPEN-05).
template <typename A>
void noSubModule(A& a) {
  constexpr std::uint16_t kAccessError = 0x2942;  // I/O access error, reading
  const std::uint32_t address = a.value("LADDR");
  cpu::DiagnosticInformation information{};
  information[2] = static_cast<std::uint8_t>(address >> 8);
  information[3] = static_cast<std::uint8_t>(address);
  a.cpu().log().note(kAccessError,
                     fmt::format("SFB {}: no positioning sub-module at address {} (16#{:X})",
                                 a.functionNumber(), address, address),
                     information);
  a.fail();
}

// A data block that is too short or write-protected stays as it is (POS-ERR-53).
template <typename A>
bool usable(A& a) {
  return a.has("JOB_VAL") && a.machine().registers.di.writable > 0;
}

template <typename A>
void run(A& a, io::AxisOutput kind) {
  if (!usable(a)) return a.fail();
  positioning::Positioning* module = a.positioning();
  if (module == nullptr || !module->answers(a.value("LADDR"))) return noSubModule(a);
  const cpu::Registers& registers = a.machine().registers;
  const auto [channel, block] =
      module->called(kind, {registers.di.number, registers.ar2 & 0xFFFFFF}, a.machine().clock);
  const bool accepted = block.call(channel, read(a));
  a.set("ERROR", block.answer().error);
  a.set("STATUS", block.answer().status);
  module->callEnded();
  a.machine().interrupt();  // what was acknowledged follows at the end of the instruction
  if (!accepted) return;
  show(a, channel.image());
  show(a, block.answer());
}

}  // namespace

void analogAxisBlock(Sfb<44>& a) { run(a, io::AxisOutput::Analog); }
void digitalAxisBlock(Sfb<46>& a) { run(a, io::AxisOutput::Digital); }

}  // namespace merker::system
