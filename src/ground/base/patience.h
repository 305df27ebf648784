// When it pays to look for something that is found again and again, or never: after some looks in
// a row that found nothing, more and more chances are left out before the next look.
#pragma once

#include <algorithm>
#include <cstdint>

namespace merker {

class Patience {
 public:
  // Whether to look at the next chance; those left out are counted.
  bool wants() {
    if (rest_ == 0) return true;
    --rest_;
    return false;
  }
  // A look in vain, for which so many bytes were compared; one that found something.
  void failed(std::size_t bytes) {
    const auto most =
        static_cast<unsigned>(std::clamp<std::size_t>(bytes / kBytesPerChance, kLeast, kMost));
    if (++failures_ > kPatience) rest_ = std::min(most, 1u << std::min(failures_ - kPatience, 30u));
  }
  void found() { failures_ = 0; }
  // It is not expected to find anything.
  bool lost() const { return failures_ > kPatience; }

 private:
  // Comparing so many bytes takes some 30 ns, a short cycle a thousand. At most every 8,192th
  // chance is taken: what a big memory costs is never waited for longer.
  static constexpr std::size_t kBytesPerChance = 512, kLeast = 64, kMost = 8'192;
  static constexpr unsigned kPatience = 4;

  unsigned failures_ = 0, rest_ = 0;
};

}  // namespace merker
