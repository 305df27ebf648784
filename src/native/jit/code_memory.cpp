#include "jit/code_memory.h"

#include <asmjit/core.h>

#include <algorithm>

namespace merker::jit {
namespace {

using asmjit::VirtMem::MemoryFlags;

// Pages are given back when the last piece in them is gone: with few pages for many blocks, the
// versions of a block that is loaded again and again take little more room than one.
constexpr std::size_t kPages = 64 * 1024;
constexpr std::size_t kAlignment = 64;  // a line of the cache

constexpr std::size_t roundUp(std::size_t size, std::size_t to) {
  return (size + to - 1) / to * to;
}

}  // namespace

class CodeMemory::Piece::Pages {
 public:
  explicit Pages(std::size_t size) : size_(size) {
    if (asmjit::VirtMem::alloc(&data_, size, MemoryFlags::kAccessRW) != asmjit::kErrorOk)
      data_ = nullptr;
  }
  ~Pages() {
    if (data_ != nullptr) asmjit::VirtMem::release(data_, size_);
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;

  bool good() const { return data_ != nullptr; }
  std::size_t size() const { return size_; }
  void* at(std::size_t offset) const { return static_cast<std::byte*>(data_) + offset; }
  bool make(MemoryFlags access) const {
    return asmjit::VirtMem::protect(data_, size_, access) == asmjit::kErrorOk;
  }

 private:
  void* data_ = nullptr;
  std::size_t size_;
};

CodeMemory::Piece CodeMemory::place(std::size_t size, const std::function<bool(void*)>& write) {
  Piece piece;
  if (pages_ != nullptr && pages_.use_count() == 1) used_ = 0;  // all pieces are gone
  if (pages_ == nullptr || used_ + size > pages_->size()) {
    const std::size_t page = asmjit::VirtMem::info().pageSize;
    auto fresh = std::make_shared<Piece::Pages>(roundUp(std::max(size, kPages), page));
    if (!fresh->good()) return piece;
    pages_ = std::move(fresh);
    used_ = 0;
  }
  if (!pages_->make(MemoryFlags::kAccessRW)) return piece;
  const bool written = write(pages_->at(used_));
  if (!pages_->make(MemoryFlags::kAccessRX) || !written) return piece;
  piece.pages_ = pages_;
  piece.data_ = pages_->at(used_);
  used_ = roundUp(used_ + size, kAlignment);
  return piece;
}

}  // namespace merker::jit
