#include <deque>

#include "jit/region_code.h"

namespace merker::jit {
namespace {

constexpr host::Gp kSaved[] = {host::rbx, host::rbp, host::r12, host::r13, host::r14, host::r15};

// rdi state, rsi where to begin
void writeEnter(host::Assembler& code, const Layout& layout) {
  for (const host::Gp& reg : kSaved) code.push(reg);
  code.sub(host::rsp, kFrame);
  code.mov(kState, host::rdi);
  code.mov(host::rax, inState(layout.image));
  for (std::size_t i = 0; i < layout.images.size(); ++i)
    code.lea(kImages[i], host::ptr(host::rax, static_cast<int>(layout.images[i]) + kBias));
  code.mov(kClock, inState(layout.clock));
  code.mov(kCount, inState(layout.instructions));
  code.jmp(host::rsi);
}

// eax: instruction to go on with
void writeEpilogue(host::Assembler& code, const Layout& layout, const Instructions& answers) {
  code.mov(inState(layout.clock), kClock);
  code.mov(inState(layout.instructions), kCount);
  code.imul(host::rax, host::rax, static_cast<int>(answers.stride));
  code.mov(host::rcx, reinterpret_cast<std::uintptr_t>(answers.first));
  code.add(host::rax, host::rcx);
  code.add(host::rsp, kFrame);
  for (std::size_t i = std::size(kSaved); i-- > 0;) code.pop(kSaved[i]);
  code.ret();
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

std::unique_ptr<NativeCode> load(asmjit::CodeHolder& code, const asmjit::Label& enter,
                                 const Unit& unit) {
  if (code.flatten() != asmjit::kErrorOk) return nullptr;
  if (code.resolveUnresolvedLinks() != asmjit::kErrorOk) return nullptr;
  const std::size_t size = code.codeSize();
  CodeMemory::Piece memory = unit.options.memory->place(size, [&](void* at) {
    return code.relocateToBase(reinterpret_cast<std::uintptr_t>(at)) == asmjit::kErrorOk &&
           code.copyFlattenedData(at, size) == asmjit::kErrorOk;
  });
  if (memory.data() == nullptr) return nullptr;
  std::vector<const void*> entries(unit.regions.size() + 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool begins = i < unit.regions.size() && unit.regions[i].isValid();
    entries[i] = static_cast<const std::uint8_t*>(memory.data()) +
                 code.labelOffset(begins ? unit.regions[i] : unit.epilogue);
  }
  return std::make_unique<NativeCode>(std::move(memory), size, code.labelOffset(enter),
                                      code.labelOffset(unit.entrance), std::move(entries));
}

}  // namespace

std::unique_ptr<NativeCode> compile(std::span<const icode::Region> regions,
                                    std::size_t instructions, const Instructions& answers,
                                    const Layout& layout, const Options& options) {
  if (regions.empty() && instructions != 0) return nullptr;
  asmjit::CodeHolder holder;
  holder.init(asmjit::Environment::host());
  host::Assembler code(&holder);
  Unit unit{code, layout, options, answers, code.newLabel()};
  unit.regions.resize(instructions);
  const asmjit::Label enter = code.newLabel();
  code.bind(enter);
  writeEnter(code, layout);
  code.bind(unit.epilogue);
  writeEpilogue(code, layout, answers);
  if (layout.frames) writeBlockChanges(unit);
  for (const icode::Region& region : regions) unit.regions[region.first] = code.newLabel();
  code.bind(unit.entrance);
  if (layout.blocks) writeEntrance(unit);
  if (!writeRegions(unit, regions)) return nullptr;
  return load(holder, enter, unit);
}

}  // namespace merker::jit
