// A SINUMERIK PLC with its NC and its function macros, programmed by listings.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "nc/function_macros.h"
#include "softplc/plc.h"

namespace merker::nc {

struct Rig {
  explicit Rig(const MacroOptions& with = {}) : macros(with) {}

  // Compiles the listing and starts. False: an error stopped the PLC.
  bool start(const std::string& listing);
  void cycles(unsigned count) { plc->advanceCycles(count); }
  void milliseconds(std::int64_t count) {
    plc->advanceTo(plc->now() + Duration::milliseconds(count));
  }
  bool stopped() const { return plc->mode() == sinumerik::Mode::Stop; }
  // "60/2": accumulators 1 and 2 of the interrupt stack, if alarm 6114 stopped the PLC; else what
  // happened.
  std::string stop();

  sinumerik::Machine& machine() { return plc->machine(); }
  unsigned flagWord(unsigned byte) const;
  void setFlagWord(unsigned byte, unsigned value);
  std::uint16_t& word(std::uint16_t block, unsigned number);
  // Byte n of the interface in DB 36.
  unsigned interfaceByte(unsigned n);

  FunctionMacros macros;
  sinumerik::Options options;
  std::optional<sinumerik::Plc> plc;
};

// A parameter list of FB 61 or FB 62 with its call.
struct Call {
  unsigned macro = 61;
  std::string signal = "M 100.0", byte = "DL 0";
  int count = 1;
  std::string type = "RPNC";
  std::array<int, 3> where{1, 50, 0};
  std::string format = "F0";
  std::string place = "0,160";
  std::string text(const std::string& jump = "SPA") const;
};

// OB 1 with this body and a data block 10 of 40 words.
std::string cyclic(const std::string& body);
std::string dataBlock(unsigned number, unsigned words);

// A rig whose OB 1 calls the macro in each cycle; the signal M 100.0 is still 0.
struct JobRig : Rig {
  explicit JobRig(const Call& call, const MacroOptions& with = {});
  // Sets the signal, waits for the end. What stopped the PLC, or "FEHLER", or "".
  std::string run();
};

}  // namespace merker::nc
