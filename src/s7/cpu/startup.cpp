#include "cpu/startup.h"

namespace merker::cpu {
namespace {

struct Row {
  Restart how;
  std::uint8_t ob, kind;  // kind: OB10x_STRTUP
  Event event;
  std::uint8_t info, unbuffered;  // bits 23..16 of STRT_INFO; after power on without buffer
};
constexpr Row kRows[] = {
    {Restart::ManualWarm, 100, 0x81, Event::WarmRestartManual, 0x03, 0x03},
    {Restart::AutomaticWarm, 100, 0x82, Event::WarmRestartAutomatic, 0x10, 0x20},
    {Restart::ManualHot, 101, 0x83, Event::HotRestartManual, 0x0B, 0x0B},
    {Restart::AutomaticHot, 101, 0x84, Event::HotRestartAutomatic, 0xA0, 0xA0},
    {Restart::ManualCold, 102, 0x85, Event::ColdRestartManual, 0x07, 0x07},
    {Restart::AutomaticCold, 102, 0x86, Event::ColdRestartAutomatic, 0x11, 0x21}};

const Row& rowOf(Restart how) { return kRows[static_cast<unsigned>(how)]; }

}  // namespace

// Byte 6 the event of the last STOP; bytes 8..11 as the manual's table "STRT_INFO" has them (System
// Software for S7-300/400, startup OBs): which start, by whom, and which starts are possible.
void Startup::begin(Restart how, const Situation& situation, std::size_t interrupted) {
  constexpr unsigned kWarmPossible = 0x77, kHotPossible = 0xFF;
  const Row& row = rowOf(how);
  const unsigned who = situation.buffered ? row.info : row.unbuffered;
  how_ = how;
  interrupted_ = interrupted;
  information_ = startInformation(0x13, row.kind, 27, row.ob, situation.time);
  setWord(information_, 6, situation.stopEvent);
  setByte(information_, 9, who);
  setByte(information_, 10, situation.hotRestart ? kHotPossible : kWarmPossible);
  setByte(information_, 11, who);
}

std::uint8_t Startup::ob() const { return rowOf(how_).ob; }
Event Startup::event() const { return rowOf(how_).event; }

}  // namespace merker::cpu
