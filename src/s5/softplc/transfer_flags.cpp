#include "softplc/transfer_flags.h"

namespace merker::sinumerik {
namespace {

// Half a period of the blink clock: 1 s at an IPO clock of 20 ms (S5-FLAG-02, OP-17).
constexpr int kBlinkClocks = 50;

constexpr std::uint8_t kStartUpOb = 20;

void setWord(Machine& m, unsigned byte, std::uint16_t value) {
  m.flags[byte] = static_cast<std::uint8_t>(value >> 8);
  m.flags[byte + 1] = static_cast<std::uint8_t>(value);
}

std::uint8_t monitoring(const Surroundings& around) {
  const NcSide& nc = around.nc;
  return static_cast<std::uint8_t>(nc.probe2 << 7 | nc.probe1 << 6 | nc.machiningStop << 3 |
                                   1 << 2 | !around.batteryGood << 1 | (nc.alarm ? 1 : 0));
}

}  // namespace

void TransferFlags::setBit(unsigned byte, unsigned bit, bool on) {
  const unsigned mask = 1u << bit;
  m_.flags[byte] = static_cast<std::uint8_t>(on ? m_.flags[byte] | mask : m_.flags[byte] & ~mask);
}

void TransferFlags::start(bool cold) {
  m_.flags[2] = cold ? 0x06 : 0x00;
  m_.flags[3] = cold ? 0x07 : 0x00;
  m_.flags[6] = m_.flags[12] = m_.flags[16] = 0;
  blink_ = false;
  level_ = 0;
}

void TransferFlags::resumeLevel(std::uint8_t ob) {
  level_ = ob;
  m_.flags[1] = ob;
}

void TransferFlags::startUpOver() {
  blink_ = false;
  ipoClocks_ = -1;  // the one that begins the raster ends none
}

void TransferFlags::enterLevel(std::uint8_t ob, const Surroundings& around) {
  const NcSide& nc = around.nc;
  m_.flags[0] = 0x02;  // M 0.0 = 0, M 0.1 = 1
  showBlink();
  if (ob != level_) m_.flags[1] = ob;
  level_ = ob;
  m_.flags[7] = 0;
  m_.flags[17] = nc.reloading;
  setWord(m_, 19, nc.blocks1);
  setWord(m_, 21, nc.blocks2);
  m_.flags[23] =
      static_cast<std::uint8_t>(nc.ringFull << 7 | nc.ringEmpty << 6 | (nc.serialRuns ? 1 : 0));
  m_.flags[24] = monitoring(around);
}

void TransferFlags::levelComplete(std::uint8_t ob) {
  if (ob == kStartUpOb) return;  // M 3.0 stays as it tells the kind of the last start
  setBit(2, ob, false);
  setBit(3, ob, false);
}

int TransferFlags::clocksUntilBlink() const { return kBlinkClocks - ipoClocks_; }

void TransferFlags::ipoClock(bool idle) {
  if (++ipoClocks_ == kBlinkClocks) {
    ipoClocks_ = 0;
    blink_ = !blink_;
  }
  if (idle) showBlink();
}

void TransferFlags::showEdges(Edges edges) {
  m_.flags[12] = edges.negative;
  m_.flags[16] = edges.positive;
}

void TransferFlags::delayed() { setBit(6, 2, true); }
void TransferFlags::fault() { setBit(8, 0, true); }

}  // namespace merker::sinumerik
