// A counter cell (S5-COUNTER, 9.3.4). The program sees it as a word: bit 15 ZWG and 14 ZKS value
// not 0, 13 edge of ZV, 12 edge of ZR, 11 FMS edge of S, 10 edge of FR, 9..0 value, binary
// (OP-33).
#pragma once

#include <cstdint>

namespace merker::sinumerik {

class Counter {
 public:
  static constexpr std::uint16_t kValue = 0x03FF;

  std::uint16_t word() const { return word_; }
  void setWord(std::uint16_t word) { word_ = word; }
  std::uint16_t value() const { return word_ & kValue; }
  bool output() const { return value() != 0; }
  std::uint16_t coded() const;  // LC Z

  // Each returns whether it did anything.
  bool set(bool vke, std::uint16_t akku);  // S Z: three BCD digits
  bool up(bool vke);                       // ZV
  bool down(bool vke);                     // ZR
  bool reset(bool vke);                    // R Z
  bool enable(bool vke);                   // FR Z: the edges of S, ZV, ZR count once more

 private:
  bool rises(std::uint16_t edge, bool vke);
  void setValue(unsigned value);

  std::uint16_t word_ = 0;
};

}  // namespace merker::sinumerik
