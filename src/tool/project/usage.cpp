#include "project/usage.h"

#include <set>

#include "mc7/disassembly.h"
#include "mc7/instruction.h"

namespace merker::project {
namespace {

struct Numbers {
  std::set<std::uint32_t> timers, counters;
};

void collect(const block::Block& block, Numbers& numbers) {
  for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German)) {
    const auto decoded =
        line.kind == mc7::LineKind::Instruction ? mc7::decode(line.bytes) : std::nullopt;
    if (!decoded) continue;
    const mc7::Operand& operand = decoded->instruction.operand;
    if (operand.kind == mc7::OperandKind::Timer) numbers.timers.insert(operand.value);
    if (operand.kind == mc7::OperandKind::Counter) numbers.counters.insert(operand.value);
  }
}

std::uint32_t workBytes(const block::Program& program) {
  std::size_t sum = 0;
  for (const auto& [id, block] : program)
    if (!block.attributes.unlinked)
      sum += block.code.empty() ? block.actualData.size() : block.code.size();
  return static_cast<std::uint32_t>(sum);
}

}  // namespace

std::vector<Usage> usage(const block::Program& program, const CpuModel& model,
                         const std::optional<io::Configuration>& hardware) {
  Numbers numbers;
  for (const auto& [id, block] : program) collect(block, numbers);
  std::vector<Usage> list{
      {"work memory", "bytes", workBytes(program), model.workMemory},
      {"timers", "T", static_cast<std::uint32_t>(numbers.timers.size()), model.timers},
      {"counters", "Z", static_cast<std::uint32_t>(numbers.counters.size()), model.counters}};
  if (!hardware) return list;
  const io::Channels channels = io::channels(*hardware);
  list.push_back({"digital channels", "", channels.digital(), model.digitalChannels});
  list.push_back({"analog channels", "", channels.analog(), model.analogChannels});
  return list;
}

}  // namespace merker::project
