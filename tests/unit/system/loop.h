// One call of SFB 41, 42 or 43 after the other, with parameters and results by name: the block is
// called by OB 1 whenever M 0.0 says so, on an instance data block DB 41.
#pragma once

#include <bit>
#include <string>
#include <string_view>

#include "program.h"

namespace merker::station::test {

class Loop {
 public:
  explicit Loop(int sfb)
      : plc_("DATA_BLOCK DB 41 SFB " + std::to_string(sfb) +
             "\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF "
             "BYTE;\nEND_VAR\nBEGIN\nUN M 0.0; BEB; R M 0.0;\nCALL SFB " +
             std::to_string(sfb) + ", DB 41;\nU BIE; = M 0.1;\nEND_ORGANIZATION_BLOCK\n") {
    plc_.start();
    (*plc_).advanceCycles(1);
  }

  void call() {
    plc_.write("M 0.0", 1);
    (*plc_).advanceCycles(1);
    EXPECT_EQ(plc_.read("M 0.0"), 0u);
    EXPECT_EQ(plc_.read("M 0.1"), 1u) << "BIE";
  }
  void set(std::string_view name, float value) {
    plc_.write(operand(name), std::bit_cast<std::uint32_t>(value));
  }
  void set(std::string_view name, double value) { set(name, static_cast<float>(value)); }
  void set(std::string_view name, bool value) { plc_.write(operand(name), value); }
  void set(std::string_view name, int value) {  // WORD, INT; TIME in ms
    const auto bits = static_cast<std::uint32_t>(value);
    plc_.write(operand(name), wide(name) ? bits : bits & 0xFFFF);
  }
  float real(std::string_view name) { return std::bit_cast<float>(raw(name)); }
  bool flag(std::string_view name) { return raw(name) != 0; }
  int word(std::string_view name) { return static_cast<std::int16_t>(raw(name)); }
  std::uint32_t raw(std::string_view name) { return plc_.read(operand(name)); }
  std::uint32_t at(std::string_view place) { return plc_.read("DB41." + std::string(place)); }
  Plc& plc() { return plc_; }

 private:
  static std::string operand(std::string_view name) { return "DB41." + std::string(name); }
  bool wide(std::string_view name) {
    return plc_.reference(operand(name)).operand.width == Width::DWord;
  }
  Plc plc_;
};

}  // namespace merker::station::test
