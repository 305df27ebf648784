// The memory of a partner that speaks RK 512: data blocks and areas of bytes, all there is from the
// beginning; timers and counters are words.
#pragma once

#include <map>

#include "serial/rk512.h"

namespace merker::serial {

class PartnerMemory : public LinkMemory {
 public:
  std::optional<std::size_t> size(char type, std::uint8_t block) const override;
  bool writable(std::uint8_t) const override { return true; }
  Bytes read(char type, std::uint8_t block, std::size_t offset, std::size_t count) const override;
  void write(std::uint8_t block, std::size_t offset, std::span<const std::uint8_t> data) override;
  bool flag(const Flag& flag) const override;
  void setFlag(const Flag& flag) override;
  // Any area: what it holds from now on; a data block begins to exist. False: beyond its end.
  bool set(char type, std::uint8_t block, std::size_t offset, std::span<const std::uint8_t> data);
  Bytes get(char type, std::uint8_t block, std::size_t offset, std::size_t count) const;

 private:
  static constexpr std::size_t kBlock = 2048, kArea = 512;
  using Key = std::pair<char, std::uint8_t>;
  static Key keyOf(char type, std::uint8_t block) {
    return {type, type == 'D' || type == 'X' ? block : std::uint8_t{0}};
  }
  std::map<Key, Bytes> areas_;
};

}  // namespace merker::serial
