// Processors other than x86-64: the interpreter serves alone.
#include "jit/native.h"

namespace merker::jit {

CodeMemory::Piece CodeMemory::place(std::size_t, const std::function<bool(void*)>&) { return {}; }

const void* NativeCode::run(void*, std::size_t) const { return nullptr; }

bool available() { return false; }
std::unique_ptr<NativeCode> compile(std::span<const icode::Region>, std::size_t,
                                    const Instructions&, const Layout&, const Options&) {
  return nullptr;
}

}  // namespace merker::jit
