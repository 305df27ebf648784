#include "control/memory.h"

#include "control/plc_options.h"
#include "softplc/memory_size.h"

namespace merker::cnc {

MemoryUse memoryUse(const Options& options) {
  const sinumerik::Options plc = plcOptions(options);
  const auto size = memorySize(plc, plc.machineData.value_or(sinumerik::MachineData()));
  MemoryUse use{{0, size.programWords}, {0, size.dataWords}, {}};
  for (const auto& [id, block] : plc.program) {
    SegmentUse& segment = id.type == mc5::BlockType::Db ? use.data : use.program;
    const auto words = static_cast<std::uint32_t>(block.words.size() + mc5::kHeaderWords);
    if (segment.used + words > segment.size)
      use.missing.push_back({id, words, segment});
    else
      segment.used += words;
  }
  return use;
}

}  // namespace merker::cnc
