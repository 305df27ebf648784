#include "jit/native.h"

#include "jit/ways.h"

namespace merker::jit {

namespace {

using Enter = const void* (*)(void* state, const void* entry);

Enter asFunction(const void* code) {
  return reinterpret_cast<Enter>(reinterpret_cast<std::uintptr_t>(code));
}

}  // namespace

const void* NativeCode::run(void* state, std::size_t instruction) const {
  return asFunction(ways_->enter)(state, entries_[instruction]);
}

bool available() { return true; }

}  // namespace merker::jit
