// Threads that do pieces of work which know nothing of each other.
#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

namespace merker::network {

class Workers {
 public:
  // One is the thread that calls each().
  explicit Workers(unsigned threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // Calls `work` with 0 … count-1, each once, and returns when all are done. The pieces are dealt
  // out like cards, so each thread has the same ones in every call.
  void each(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void share(std::size_t first) const;

  std::size_t size_;
  std::size_t count_ = 0;
  const std::function<void(std::size_t)>* work_ = nullptr;  // null: the end
  std::optional<std::barrier<>> begin_, end_;
  std::vector<std::jthread> threads_;
};

}  // namespace merker::network
