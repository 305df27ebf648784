// The rows of the CPU models. Numbers without a source in the course come from the device manuals:
// docs/compatibility.md, "CPU models".
#include <array>

#include "catalogue/cpu_model.h"

namespace merker {
namespace {

// S7-CPU-30; OB 86 needs a DP master.
constexpr std::array<std::uint8_t, 13> kObs31xC{1,  10, 20, 35,  40,  80, 81,
                                                82, 85, 87, 100, 121, 122};
constexpr std::array<std::uint8_t, 14> kObs31xCDp{1,  10, 20, 35, 40,  80,  81,
                                                  82, 85, 86, 87, 100, 121, 122};
constexpr std::array<std::uint8_t, 22> kObs314Pn{1,  10, 20, 21, 32, 33, 34, 35, 40,  55,  56,
                                                 57, 80, 81, 82, 83, 85, 86, 87, 100, 121, 122};
constexpr std::array<std::uint8_t, 3> kObs312Ifm{1, 40, 100};
constexpr std::array<std::uint8_t, 22> kObs318{1,  10, 11, 20, 21, 32, 35,  40,  41,  80,  81,
                                               82, 83, 84, 85, 86, 87, 100, 102, 121, 122, 60};
// The whole table of chapter 5.1 with OB 102 (S7-OPEN-42), and those that only other CPUs have: a
// program for one of them compiles, and nothing starts them.
constexpr std::array<std::uint8_t, 59> kObsAll{
    1,  10, 11, 12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 30, 31,  32,  33,  34,  35, 36,
    37, 38, 40, 41, 42, 43, 44, 45, 46, 47, 50, 51, 55, 56, 57,  60,  61,  62,  63, 64,
    65, 70, 72, 73, 80, 81, 82, 83, 84, 85, 86, 87, 88, 90, 100, 101, 102, 121, 122};

// Compressing, parts of the process image and synchronising clocks: CPU 318-2 and S7-400.
constexpr std::array<std::uint8_t, 4> kNotOn31x{25, 26, 27, 48};

// Closed-loop control: CPU 313C, 313C-2 and 314C-2; counting also CPU 312C (technology manual 1,
// table "Übersicht technologische Funktionen"; PID-USE-01).
// Positioning: CPU 314C-2 only (POS-OVW-01, -02). Point-to-point: only the two CPUs with the
// interface X27, RK 512 only one of them (PTP-OVW-01, PTP-OPEN-28).
// S7 communication as a client: SFBs of an S7-400 (S7-SFB-10); of these models the generic ones
// alone.
constexpr std::array<std::uint8_t, 6> kNoPartners{8, 9, 12, 13, 14, 15};
constexpr std::array<std::uint8_t, 12> kNoSerial{8, 9, 12, 13, 14, 15, 60, 61, 62, 63, 64, 65};
constexpr std::array<std::uint8_t, 14> kNoPositioning{8,  9,  12, 13, 14, 15, 44,
                                                      46, 60, 61, 62, 63, 64, 65};
constexpr std::array<std::uint8_t, 11> kNoPositioningNoLink{8,  9,  12, 13, 14, 15,
                                                            44, 46, 63, 64, 65};
constexpr std::array<std::uint8_t, 17> kNoControl{8,  9,  12, 13, 14, 15, 41, 42, 43,
                                                  44, 46, 60, 61, 62, 63, 64, 65};
constexpr std::array<std::uint8_t, 20> kNoTechnology{8,  9,  12, 13, 14, 15, 41, 42, 43, 44,
                                                     46, 47, 48, 49, 60, 61, 62, 63, 64, 65};

// On-board inputs and outputs by type (technology manual, table "Übersicht technologische
// Funktionen" and connector tables 5.2.2; S7-CPU-15 to -18).
constexpr OnBoard kOnBoard312{
    .digitalInputs = 10, .digitalOutputs = 6, .counters = 2, .digital = 124, .counting = 768};
constexpr OnBoard kOnBoard313{.digitalInputs = 24,
                              .digitalOutputs = 16,
                              .analogInputs = 5,
                              .analogOutputs = 2,
                              .counters = 3,
                              .digital = 124,
                              .analog = 752,
                              .counting = 768};
constexpr OnBoard kOnBoard3132{
    .digitalInputs = 16, .digitalOutputs = 16, .counters = 3, .digital = 124, .counting = 768};
constexpr OnBoard kOnBoard314{.digitalInputs = 24,
                              .digitalOutputs = 16,
                              .analogInputs = 5,
                              .analogOutputs = 2,
                              .counters = 4,
                              .positioning = 1,
                              .digital = 124,
                              .analog = 752,
                              .counting = 768,
                              .positions = 784};
constexpr OnBoard kOnBoard314Pn{.digitalInputs = 24,
                                .digitalOutputs = 16,
                                .analogInputs = 5,
                                .analogOutputs = 2,
                                .counters = 4,
                                .positioning = 1,
                                .digital = 136,
                                .analog = 800,
                                .counting = 816,
                                .positions = 832};
constexpr OnBoard withSerial(OnBoard onBoard, bool computerLink) {
  onBoard.serial = true;
  onBoard.computerLink = computerLink;
  return onBoard;
}
constexpr OnBoard kOnBoardIfm{.digitalInputs = 10, .digitalOutputs = 6, .digital = 124};

// Course 2.1 (S7-CPU-02..14); 500 us per cycle: docs/compatibility.md, "cycle time of the operating
// system".
constexpr CpuModel model314(std::string_view name, std::string_view keyword,
                            std::string_view orderNumber, std::span<const std::uint8_t> obs) {
  return {.name = name,
          .keyword = keyword,
          .orderNumber = orderNumber,
          .firmware = {2, 0, 0},
          .lacksSfcs = kNotOn31x,
          .lacksSfbs = kNoSerial,
          .bitTime = 100,
          .wordTime = 200,
          .fixedTime = 2'000,
          .realTime = 20'000,
          .cycleTime = 500'000,
          .workMemory = 48 * 1024,
          .blockSize = 16 * 1024,
          .dataBlockSize = 16 * 1024,
          .flagBytes = 256,
          .imageBytes = 128,
          .peripheralBytes = 1024,
          .localBytes = 510,
          .timers = 256,
          .counters = 256,
          .runtimeMeters = 1,
          .highestDb = 127,
          .highestFb = 127,
          .highestFc = 127,
          .nesting = 8,
          .errorNesting = 4,
          .bracketDepth = 7,
          .mcrDepth = 8,
          .accumulators = 2,
          .cycleMonitoring = 150,
          .retentiveFlags = 16,
          .retentiveTimers = 0,
          .retentiveCounters = 8,
          .hotRestart = false,
          .coldRestart = false,
          .allPeripheral = false,
          .racks = 4,
          .digitalChannels = 1016,
          .analogChannels = 253,
          .busCurrent = 1200,
          .loadMemory = 8u << 20,
          .onBoard = kOnBoard314,
          .organizationBlocks = obs};
}

// Device manual "CPU 31xC and CPU 31x", firmware V2.0 of 2004.
constexpr CpuModel model313(std::string_view name, std::string_view keyword,
                            std::string_view orderNumber, std::span<const std::uint8_t> obs,
                            const OnBoard& onBoard) {
  CpuModel model = model314(name, keyword, orderNumber, obs);
  model.lacksSfbs = kNoPositioning;
  model.realTime = 3'000;
  model.workMemory = 32 * 1024;
  model.highestDb = 511;
  model.highestFb = model.highestFc = 2047;
  model.onBoard = onBoard;
  const bool analog = onBoard.analogInputs > 0;
  model.digitalChannels = analog ? 1016 : 1008;
  model.analogChannels = analog ? 253 : 248;
  return model;
}

constexpr CpuModel model312C() {
  CpuModel model = model313("CPU 312C", "312C", "6ES7 312-5BD01-0AB0", kObs31xC, kOnBoard312);
  model.lacksSfbs = kNoControl;
  model.bitTime = 200;
  model.wordTime = 400;
  model.fixedTime = 5'000;
  model.realTime = 6'000;
  model.workMemory = 16 * 1024;
  model.flagBytes = 128;
  model.localBytes = 256;
  model.timers = model.counters = 128;
  model.racks = 1;
  model.digitalChannels = 266;
  model.analogChannels = 64;
  model.busCurrent = 800;
  model.loadMemory = 4u << 20;
  return model;
}

// Firmware V3.3, the one of the technology manual.
constexpr CpuModel model314Pn() {
  CpuModel model = model314("CPU 314C-2 PN/DP", "314C-2 PN/DP", "6ES7 314-6EH04-0AB0", kObs314Pn);
  model.firmware[0] = 3;
  model.firmware[1] = 3;
  model.bitTime = 60;
  model.wordTime = 120;
  model.fixedTime = 160;
  model.realTime = 590;
  model.workMemory = 192 * 1024;
  model.blockSize = model.dataBlockSize = 64 * 1024;
  model.imageBytes = 256;
  model.peripheralBytes = 2048;
  model.localBytes = 2048;
  model.highestDb = 16'000;
  model.highestFb = model.highestFc = 7999;
  model.nesting = 16;
  model.digitalChannels = 1016;
  model.onBoard = kOnBoard314Pn;
  return model;
}

// Course 3.3 (S7-CPU-21); device manual "CPU 312 IFM to CPU 318-2 DP".
constexpr CpuModel model312Ifm() {
  CpuModel model = model314("CPU 312 IFM", "312 IFM", "6ES7 312-5AC02-0AB0", kObs312Ifm);
  model.firmware[0] = 1;
  model.lacksSfbs = kNoTechnology;
  model.runtimeMeters = 0;
  model.bitTime = 600;
  model.wordTime = 2'000;
  model.fixedTime = 3'000;
  model.realTime = 60'000;
  model.workMemory = 6 * 1024;
  model.blockSize = model.dataBlockSize = 6 * 1024;
  model.flagBytes = 128;
  model.localBytes = 256;
  model.timers = 64;
  model.counters = 32;
  model.highestDb = 63;
  model.highestFb = model.highestFc = 31;
  model.racks = 1;
  model.digitalChannels = 256 + 16;  // "256 + 10 integrated": 10 inputs, and 6 outputs
  model.analogChannels = 64;
  model.busCurrent = 800;
  model.loadMemory = 20 * 1024;
  model.onBoard = kOnBoardIfm;
  return model;
}

// Course 3.3 (S7-CPU-22); the same manual.
constexpr CpuModel model318() {
  CpuModel model = model314("CPU 318-2", "318-2", "6ES7 318-2AJ00-0AB0", kObs318);
  model.firmware[0] = 3;
  model.lacksSfcs = {};
  model.lacksSfbs = kNoTechnology;
  model.runtimeMeters = 8;
  model.bitTime = model.wordTime = model.fixedTime = 100;
  model.realTime = 600;
  model.workMemory = 256 * 1024;
  model.blockSize = model.dataBlockSize = 64 * 1024 - 2;
  model.flagBytes = 8192;
  model.imageBytes = 256;
  model.peripheralBytes = 8192;
  model.localBytes = 4096;
  model.timers = model.counters = 512;
  model.highestDb = 2047;
  model.highestFb = model.highestFc = 1023;
  model.nesting = 16;
  model.errorNesting = 3;
  model.accumulators = 4;
  model.coldRestart = true;
  model.digitalChannels = 65'536;
  model.analogChannels = 4096;
  model.loadMemory = 2u << 20;
  model.onBoard = {};
  return model;
}

constexpr CpuModel withPointToPoint(CpuModel model, bool computerLink) {
  model.lacksSfbs = kNoPartners;
  if (!computerLink) model.lacksSfbs = kNoPositioningNoLink;
  model.onBoard = withSerial(model.onBoard, computerLink);
  return model;
}

// "An S7 CPU without a particular model's limits": the contract of the command line.
constexpr CpuModel modelGeneric(std::string_view name, std::string_view keyword,
                                std::uint32_t accumulators) {
  CpuModel model = model314(name, keyword, "", kObsAll);
  model.lacksSfcs = {};
  model.lacksSfbs = {};
  model.runtimeMeters = 8;
  model.bitTime = model.wordTime = model.fixedTime = model.realTime = 100;
  model.workMemory = 64u << 20;
  model.blockSize = model.dataBlockSize = 65'536;
  model.flagBytes = model.imageBytes = model.peripheralBytes = model.localBytes = 65'536;
  model.timers = model.counters = 65'536;
  model.highestDb = model.highestFb = model.highestFc = 65'535;
  model.nesting = 256;
  model.errorNesting = 16;
  model.bracketDepth = model.mcrDepth = 64;
  model.accumulators = accumulators;
  model.cycleMonitoring = 6'000;
  model.hotRestart = model.coldRestart = model.allPeripheral = true;
  model.digitalChannels = model.analogChannels = 65'536;
  model.loadMemory = 64u << 20;
  model.onBoard = {};
  return model;
}

constexpr std::array kModels{
    withPointToPoint(model314("CPU 314C-2 PtP", "314C-2 PtP", "6ES7 314-6BF01-0AB0", kObs31xC),
                     true),
    model314("CPU 314C-2 DP", "314C-2 DP", "6ES7 314-6CF01-0AB0", kObs31xCDp),
    model314Pn(),
    model313("CPU 313C", "313C", "6ES7 313-5BE01-0AB0", kObs31xC, kOnBoard313),
    withPointToPoint(
        model313("CPU 313C-2 PtP", "313C-2 PtP", "6ES7 313-6BE01-0AB0", kObs31xC, kOnBoard3132),
        false),
    model313("CPU 313C-2 DP", "313C-2 DP", "6ES7 313-6CE01-0AB0", kObs31xCDp, kOnBoard3132),
    model312C(),
    model312Ifm(),
    model318(),
    modelGeneric("generic S7 CPU", "generic", 2),
    modelGeneric("generic S7 CPU with 4 accumulators", "generic-4", 4),
};

}  // namespace

std::span<const CpuModel> cpuModels() { return kModels; }

}  // namespace merker
