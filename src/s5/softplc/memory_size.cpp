#include "softplc/memory_size.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint32_t kWordsPerKbyte = 512, kParagraphsPerKbyte = 0x40;
constexpr std::uint32_t kCop = 12, kAcop = 16, kExtended = 48;  // kbytes of program

bool isCop(const Options& options) { return options.variant == mc5::Variant::Cop; }
bool isNew(const Options& options) { return !isCop(options) && options.software == Software::Sw2; }

}  // namespace

bool hasExtension(const Options& options) { return options.memoryExtension && isNew(options); }

MemorySize memorySize(const Options& options, const MachineData& data) {
  const std::uint32_t program = hasExtension(options) ? kExtended : isCop(options) ? kCop : kAcop;
  const std::uint32_t more = hasExtension(options) ? data.word(9) * kWordsPerKbyte : 0;
  return {program * kWordsPerKbyte, kUserDataWords + more};
}

// From SW 2 on the program lies behind the data, whose extension moves it (S5-MEM-T1).
Layout layoutOf(const Options& options, const MachineData& data) {
  if (!isNew(options)) return {0x1000, 0x1400, !isCop(options)};
  const std::uint32_t more = hasExtension(options) ? data.word(9) * kParagraphsPerKbyte : 0;
  return {static_cast<std::uint16_t>(0x1400 + more), 0x1280, true};
}

std::uint32_t directoryOffset(const Options& options, const MachineData& data, mc5::BlockType type,
                              bool resident) {
  if (resident) return isNew(options) ? 0x800 : isCop(options) ? 0x8000 : 0x6000;
  if (type == mc5::BlockType::Db) return isNew(options) ? 0x1400 : isCop(options) ? 0x8000 : 0x2000;
  if (!isNew(options)) return 0;
  return 0x2000 + (hasExtension(options) ? data.word(9) * 0x20u : 0u);
}

}  // namespace merker::sinumerik
