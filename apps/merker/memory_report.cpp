#include "memory_report.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "block/memory.h"
#include "mc7/disassembly.h"
#include "mc7/instruction.h"

namespace merker::app {
namespace {

struct Numbers {
  std::set<std::uint32_t> timers, counters;
};

// Timers and counters that the program names; those reached by a number in memory are not seen.
Numbers named(const block::Program& program) {
  Numbers numbers;
  for (const auto& [id, block] : program)
    for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German)) {
      const auto decoded = line.kind == mc7::LineKind::Instruction ? mc7::decode(line.bytes)
                                                                   : std::optional<mc7::Decoded>();
      if (!decoded) continue;
      const mc7::Operand& operand = decoded->instruction.operand;
      if (operand.kind == mc7::OperandKind::Timer) numbers.timers.insert(operand.value);
      if (operand.kind == mc7::OperandKind::Counter) numbers.counters.insert(operand.value);
    }
  return numbers;
}

std::size_t loadSum(const block::Program& program) {
  std::size_t bytes = 0;
  for (const auto& [id, block] : program) bytes += block::loadMemory(block);
  return bytes;
}

// Bytes of system memory by area.
std::vector<std::pair<const char*, std::size_t>> systemMemory(const CpuModel& model) {
  return {{"process image of the inputs", model.imageBytes},
          {"process image of the outputs", model.imageBytes},
          {"flags", model.flagBytes},
          {"local data of a priority class", model.localBytes}};
}

}  // namespace

std::vector<Resource> resources(const Build& build) {
  const CpuModel& model = *build.project.model;
  const Numbers numbers = named(*build.program);
  return {{"work memory", "bytes", block::workMemory(*build.program), model.workMemory},
          {"timers", "", numbers.timers.size(), model.timers},
          {"counters", "", numbers.counters.size(), model.counters}};
}

void printMemory(const Build& build) {
  for (const auto& [id, block] : *build.program)
    if (id.kind != BlockKind::UDT)
      std::cout << fmt::format("{:<32} load {:>6}  work {:>6}\n", toString(id),
                               block::loadMemory(block), block::workMemory(block));
  std::cout << fmt::format("{:<32} load {:>6}  work {:>6}\n", "all blocks", loadSum(*build.program),
                           block::workMemory(*build.program));
  for (const auto& [name, bytes] : systemMemory(*build.project.model))
    std::cout << fmt::format("{:<32} system {:>4}\n", name, bytes);
  for (const Resource& r : resources(build))
    std::cout << fmt::format("{:<32} {} of {}{}{}, {} %{}\n", r.name, r.used, r.available,
                             r.unit.empty() ? "" : " ", r.unit, r.percent(),
                             r.noReserve() ? ": no expansion reserve" : "");
}

nlohmann::json memoryToJson(const Build& build) {
  nlohmann::json document = {{"load_bytes", loadSum(*build.program)},
                             {"work_bytes", block::workMemory(*build.program)}};
  for (const auto& [name, bytes] : systemMemory(*build.project.model))
    document["system_bytes"][name] = bytes;
  for (const Resource& r : resources(build))
    document["resources"].push_back({{"name", r.name},
                                     {"used", r.used},
                                     {"available", r.available},
                                     {"percent", r.percent()},
                                     {"no_reserve", r.noReserve()}});
  return document;
}

}  // namespace merker::app
