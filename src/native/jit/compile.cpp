#include <deque>

#include "jit/region_code.h"

namespace merker::jit {
namespace {

// eax: instruction to go on with
void writeEpilogue(const Unit& unit) {
  host::Assembler& code = unit.code;
  if (unit.answers.stride != 1)
    code.imul(host::rax, host::rax, static_cast<int>(unit.answers.stride));
  if (unit.answers.first != nullptr) {
    code.mov(host::rcx, reinterpret_cast<std::uintptr_t>(unit.answers.first));
    code.add(host::rax, host::rcx);
  }
  code.jmp(asmjit::imm(unit.ways.leave));
}

// The straight ways of all regions one behind the other, then what is rarely taken. False: a region
// did not fit.
bool writeRegions(Unit& unit, std::span<const icode::Region> regions) {
  std::deque<RegionCode> written;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const std::uint32_t next = i + 1 < regions.size() ? regions[i + 1].first : UINT32_MAX;
    if (!written.emplace_back(unit, regions[i]).write(next)) return false;
  }
  for (RegionCode& region : written) region.writeWaysOut();
  return true;
}

std::unique_ptr<NativeCode> load(asmjit::CodeHolder& code, std::shared_ptr<const Ways> ways,
                                 const Unit& unit) {
  CodeMemory::Piece memory = placed(code, *unit.options.memory);
  if (memory.data() == nullptr) return nullptr;
  std::vector<const void*> entries(unit.regions.size() + 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool begins = i < unit.regions.size() && unit.regions[i].isValid();
    entries[i] = static_cast<const std::uint8_t*>(memory.data()) +
                 code.labelOffset(begins ? unit.regions[i] : unit.epilogue);
  }
  return std::make_unique<NativeCode>(std::move(ways), std::move(memory), code.codeSize(),
                                      code.labelOffset(unit.entrance), std::move(entries));
}

}  // namespace

std::unique_ptr<NativeCode> compile(std::span<const icode::Region> regions,
                                    std::size_t instructions, const Instructions& answers,
                                    const Layout& layout, const Options& options) {
  if (regions.empty() && instructions != 0) return nullptr;
  auto ways = commonWays(layout, *options.memory);
  if (ways == nullptr) return nullptr;
  asmjit::CodeHolder holder;
  holder.init(asmjit::Environment::host());
  host::Assembler code(&holder);
  Unit unit{code, layout, options, answers, *ways, code.newLabel()};
  unit.regions.resize(instructions);
  code.bind(unit.epilogue);
  writeEpilogue(unit);
  for (const icode::Region& region : regions) unit.regions[region.first] = code.newLabel();
  code.bind(unit.entrance);
  if (layout.blocks) writeEntrance(unit);
  if (!writeRegions(unit, regions)) return nullptr;
  return load(holder, std::move(ways), unit);
}

}  // namespace merker::jit
