// Everything in which two CPUs can differ, as text; comparing costs nothing but the comparison.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cpu/cpu.h"

namespace merker::differential {

class Comparison {
 public:
  // One value of both; `index` where there are several of the name.
  template <typename T>
  void value(std::string_view name, std::size_t index, const T& interpreted, const T& compiled) {
    if (interpreted != compiled)
      line(name, index, fmt::format("{}", interpreted), fmt::format("{}", compiled));
  }
  template <typename T>
  void value(std::string_view name, const T& interpreted, const T& compiled) {
    value(name, 0, interpreted, compiled);
  }
  void hex(std::string_view name, std::size_t index, std::uint32_t interpreted,
           std::uint32_t compiled) {
    if (interpreted != compiled)
      line(name, index, fmt::format("{:08X}", interpreted), fmt::format("{:08X}", compiled));
  }
  // The rows of 16 bytes that are not the same.
  void bytes(std::string_view name, std::size_t index, std::span<const std::uint8_t> interpreted,
             std::span<const std::uint8_t> compiled) {
    value(name, index, interpreted.size(), compiled.size());
    const std::size_t size = std::min(interpreted.size(), compiled.size());
    if (!std::equal(interpreted.begin(), interpreted.begin() + static_cast<std::ptrdiff_t>(size),
                    compiled.begin()))
      rows(name, index, interpreted.first(size), compiled.first(size));
  }

  const std::string& text() const { return text_; }

 private:
  void line(std::string_view name, std::size_t index, std::string_view interpreted,
            std::string_view compiled);
  void rows(std::string_view name, std::size_t index, std::span<const std::uint8_t> interpreted,
            std::span<const std::uint8_t> compiled);
  std::string text_;
};

// The whole state of both CPUs; of the diagnostic buffer the entries after the first `seen`. Empty
// if they are the same.
std::string compare(cpu::Cpu& interpreted, cpu::Cpu& compiled, std::uint64_t seen = 0);

}  // namespace merker::differential
