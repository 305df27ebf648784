// The options of `merker run`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cpu_option.h"
#include "serial_option.h"
#include "serve.h"

namespace merker::app {

constexpr unsigned kMostThreads = 256;

struct RunOptions {
  ProjectOptions project;
  std::string path, card, time, trace, engine;
  SerialOptions serial;
  std::uint64_t cycles = 0;
  bool hasCycles = false, copyRamToRom = false, json = false, noWorkbench = false, noSkip = false;
  std::optional<unsigned> threads;  // of several stations; none: those of the computer
  std::vector<std::string> set, print, watch;
  ServeOptions serve;
};

}  // namespace merker::app
