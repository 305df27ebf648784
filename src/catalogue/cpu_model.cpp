#include "catalogue/cpu_model.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace merker {
namespace {

// S7-CPU-30; OB 86 needs a DP master.
constexpr std::array<std::uint8_t, 14> kObs314Ptp{1,  10, 20, 35,  40,  80,  81,
                                                  82, 85, 87, 100, 121, 122, 0};
constexpr std::array<std::uint8_t, 14> kObs314Dp{1,  10, 20, 35, 40,  80,  81,
                                                 82, 85, 86, 87, 100, 121, 122};
// The whole table of chapter 5.1 with OB 102 (S7-OPEN-42).
constexpr std::array<std::uint8_t, 47> kObsAll{1,  10, 11, 12, 13, 14,  15,  16,  17,  20,  21, 22,
                                               23, 30, 31, 32, 33, 34,  35,  36,  37,  38,  40, 41,
                                               42, 43, 44, 45, 46, 47,  50,  51,  60,  80,  81, 82,
                                               83, 84, 85, 86, 87, 100, 101, 102, 121, 122, 0};

// Course 2.1 (S7-CPU-02..11); 500 us per cycle: docs/compatibility.md, "cycle time of the operating
// system".
constexpr CpuModel model314(std::string_view name, std::string_view keyword,
                            std::span<const std::uint8_t> obs) {
  return {.name = name,
          .keyword = keyword,
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
          .organizationBlocks = obs};
}

// "An S7 CPU without a particular model's limits": the contract of the command line.
constexpr CpuModel modelGeneric(std::string_view name, std::string_view keyword,
                                std::uint32_t accumulators) {
  return {.name = name,
          .keyword = keyword,
          .bitTime = 100,
          .wordTime = 100,
          .fixedTime = 100,
          .realTime = 100,
          .cycleTime = 500'000,
          .workMemory = 64u << 20,
          .blockSize = 65'536,
          .dataBlockSize = 65'536,
          .flagBytes = 65'536,
          .imageBytes = 65'536,
          .peripheralBytes = 65'536,
          .localBytes = 65'536,
          .timers = 65'536,
          .counters = 65'536,
          .highestDb = 65'535,
          .highestFb = 65'535,
          .highestFc = 65'535,
          .nesting = 256,
          .errorNesting = 16,
          .bracketDepth = 64,
          .mcrDepth = 64,
          .accumulators = accumulators,
          .cycleMonitoring = 6'000,
          .retentiveFlags = 16,
          .retentiveTimers = 0,
          .retentiveCounters = 8,
          .hotRestart = true,
          .coldRestart = true,
          .allPeripheral = true,
          .organizationBlocks = kObsAll};
}

constexpr std::array kModels{
    model314("CPU 314C-2 PtP", "314C-2 PtP", std::span(kObs314Ptp).first(13)),
    model314("CPU 314C-2 DP", "314C-2 DP", kObs314Dp),
    modelGeneric("generic S7 CPU", "generic", 2),
    modelGeneric("generic S7 CPU with 4 accumulators", "generic-4", 4),
};

std::string normalised(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != ' ') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result.starts_with("cpu") ? result.substr(3) : result;
}

}  // namespace

bool CpuModel::hasOrganizationBlock(unsigned number) const {
  return std::find(organizationBlocks.begin(), organizationBlocks.end(), number) !=
         organizationBlocks.end();
}

bool CpuModel::allows(BlockId id) const {
  switch (id.kind) {
    case BlockKind::OB:
      return id.number != 0 && hasOrganizationBlock(id.number);
    case BlockKind::DB:
      return id.number != 0 && id.number <= highestDb;
    case BlockKind::FB:
      return id.number <= highestFb;
    case BlockKind::FC:
      return id.number <= highestFc;
    case BlockKind::SDB:
      return false;
    case BlockKind::UDT:
    case BlockKind::SFC:
    case BlockKind::SFB:
      return true;
  }
  return false;
}

std::span<const CpuModel> cpuModels() { return kModels; }
const CpuModel& defaultCpuModel() { return kModels.front(); }

const CpuModel* findCpuModel(std::string_view name) {
  const std::string wanted = normalised(name);
  for (const CpuModel& model : kModels)
    if (wanted == normalised(model.keyword) || wanted == normalised(model.name)) return &model;
  return nullptr;
}

}  // namespace merker
