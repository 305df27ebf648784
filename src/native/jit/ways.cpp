#include "jit/ways.h"

namespace merker::jit {
namespace {

constexpr host::Gp kSaved[] = {host::rbx, host::rbp, host::r12, host::r13, host::r14, host::r15};

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

void writeLeave(host::Assembler& code, const Layout& layout) {
  code.mov(inState(layout.clock), kClock);
  code.mov(inState(layout.instructions), kCount);
  code.add(host::rsp, kFrame);
  for (std::size_t i = std::size(kSaved); i-- > 0;) code.pop(kSaved[i]);
  code.ret();
}

void locate(Ways& ways, const asmjit::CodeHolder& code, const BlockWays& labels) {
  const auto at = [&](const asmjit::Label& label) {
    return static_cast<const std::uint8_t*>(ways.memory.data()) + code.labelOffset(label);
  };
  ways.enterBlock = at(labels.enterBlock);
  ways.enterWithout = at(labels.enterWithout);
  ways.leaveBlock = at(labels.leaveBlock);
  ways.canCallFunction = at(labels.canCallFunction);
  ways.canCallFunctionBlock = at(labels.canCallFunctionBlock);
  ways.pushFrame = at(labels.pushFrame);
  ways.pushKept = at(labels.pushKept);
}

std::shared_ptr<const Ways> written(const Layout& layout, CodeMemory& memory) {
  asmjit::CodeHolder holder;
  holder.init(asmjit::Environment::host());
  host::Assembler code(&holder);
  writeEnter(code, layout);
  const std::size_t leave = code.offset();
  writeLeave(code, layout);
  BlockWays labels;
  if (layout.frames) labels = writeBlockWays(code, layout);
  auto ways = std::make_shared<Ways>();
  ways->layout = layout;
  ways->memory = placed(holder, memory);
  if (ways->memory.data() == nullptr) return nullptr;
  ways->enter = ways->memory.data();
  ways->leave = static_cast<const std::uint8_t*>(ways->enter) + leave;
  if (layout.frames) locate(*ways, holder, labels);
  return ways;
}

}  // namespace

CodeMemory::Piece placed(asmjit::CodeHolder& code, CodeMemory& memory) {
  if (code.flatten() != asmjit::kErrorOk) return {};
  if (code.resolveUnresolvedLinks() != asmjit::kErrorOk) return {};
  const std::size_t size = code.codeSize();
  return memory.place(size, [&](void* at) {
    return code.relocateToBase(reinterpret_cast<std::uintptr_t>(at)) == asmjit::kErrorOk &&
           code.copyFlattenedData(at, size) == asmjit::kErrorOk;
  });
}

std::shared_ptr<const Ways> commonWays(const Layout& layout, CodeMemory& memory) {
  if (auto known = memory.ways.lock(); known != nullptr && known->layout == layout) return known;
  auto made = written(layout, memory);
  memory.ways = made;
  return made;
}

}  // namespace merker::jit
