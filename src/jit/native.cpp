#include "jit/native.h"

#include <asmjit/core.h>

#include <utility>

namespace merker::jit {

using asmjit::VirtMem::MemoryFlags;

CodeMemory::CodeMemory(std::size_t size) : size_(size) {
  if (asmjit::VirtMem::alloc(&data_, size, MemoryFlags::kAccessRW) != asmjit::kErrorOk)
    data_ = nullptr;
}
CodeMemory::~CodeMemory() {
  if (data_ != nullptr) asmjit::VirtMem::release(data_, size_);
}
CodeMemory::CodeMemory(CodeMemory&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}
CodeMemory& CodeMemory::operator=(CodeMemory&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}
bool CodeMemory::makeExecutable() {
  return asmjit::VirtMem::protect(data_, size_, MemoryFlags::kAccessRX) == asmjit::kErrorOk;
}

namespace {

using Enter = const void* (*)(void* state, const void* entry, const void* timers,
                              const void* counters);

Enter entrance(const void* code) {
  return reinterpret_cast<Enter>(reinterpret_cast<std::uintptr_t>(code));
}

}  // namespace

const void* NativeCode::run(cpu::Machine& m, std::size_t instruction) const {
  return entrance(at(enter_))(&m, entries_[instruction], m.timers.data(), m.counters.data());
}
const void* NativeCode::run(void* state, std::size_t instruction) const {
  return entrance(at(enter_))(state, entries_[instruction], nullptr, nullptr);
}

bool available() { return true; }

}  // namespace merker::jit
