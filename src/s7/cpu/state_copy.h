// A copy of everything in the memory of a CPU that a cycle can change, kept up to date by
// comparing.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cpu/machine.h"

namespace merker::cpu {

class StateCopy {
 public:
  // Where the machine first differs from the copy.
  struct Difference {
    std::string_view area;     // "M", "DB", "T"; empty: there is none
    std::uint32_t number = 0;  // of the data block, timer or counter; the first byte of PE
    std::uint32_t byte = 0;
    explicit operator bool() const { return !area.empty(); }
  };
  // Makes the copy the same as the machine again. Inputs behind the process image count if a
  // program reads them.
  Difference update(const Machine& machine, bool allInputs);
  std::size_t bytes() const { return bytes_; }  // that it has compared
  // Of the machine at the last update.
  const std::vector<std::uint32_t>& startedTimers() const { return startedTimers_; }

 private:
  void takeTimers(const std::vector<S5Timer>& timers);
  bool take(const void* data, std::size_t bytes, std::string_view area, std::uint32_t number = 0);
  void keepPart();  // as it is: nobody asks for it
  void takeImage(const Areas& areas);
  void takeLocalStacks(const Machine& machine);

  std::vector<std::vector<std::uint8_t>> parts_;
  std::size_t part_ = 0;  // that comes next
  std::size_t bytes_ = 0;
  Difference found_;
  std::vector<std::uint32_t> startedTimers_;
};

}  // namespace merker::cpu
