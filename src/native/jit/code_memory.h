// Where machine code lies: the blocks of one station side by side, in pages that are writable or
// executable, never both. A page for each block would cost more time than the code saves: a CPU
// with a thousand small blocks would look up a thousand pages and use one line of each cache set.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace merker::jit {

struct Ways;

class CodeMemory {
 public:
  // Machine code of one block; gives its place back when it goes.
  class Piece {
   public:
    Piece() = default;
    void* data() const { return data_; }  // null: there was no room

   private:
    friend class CodeMemory;
    class Pages;
    std::shared_ptr<Pages> pages_;
    void* data_ = nullptr;
  };

  // `write` fills `size` bytes at the address that it gets; false: it could not. Not while code of
  // this memory runs: its pages are writable for that moment. A piece without data if the system
  // gives no memory, or none that may be executed.
  Piece place(std::size_t size, const std::function<bool(void*)>& write);

  // In this memory, for as long as there are blocks that use them (ways.h).
  std::weak_ptr<const Ways> ways{};

 private:
  std::shared_ptr<Piece::Pages> pages_;  // where there may be room left
  std::size_t used_ = 0;                 // bytes of them
};

}  // namespace merker::jit
