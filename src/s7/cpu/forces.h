// Forced bits of E and A (S7-CPU-31): mask and value over Areas::image. They are applied around
// each OB 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace merker::cpu {

struct Force {
  std::uint32_t byte;  // of Areas::image
  std::uint8_t mask, value;
};

class Forces {
 public:
  void set(std::uint32_t imageByte, std::uint8_t mask, std::uint8_t value) {
    list_.push_back({imageByte, mask, value});
  }
  void release() { list_.clear(); }
  void release(std::uint32_t imageByte, std::uint8_t mask);
  bool empty() const { return list_.empty(); }
  const std::vector<Force>& all() const { return list_; }
  void apply(std::span<std::uint8_t> image) const;

 private:
  std::vector<Force> list_;
};

}  // namespace merker::cpu
