// What happens when a module does not answer while the process images are updated (S7-OBI-10):
// events for OB 85, by the parameters of the CPU in each cycle or when the fault comes and goes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "catalogue/cpu_parameters.h"
#include "cpu/areas.h"

namespace merker::cpu {

struct ImageFault {
  std::uint8_t faultId;  // FLT_ID of OB 85
  bool coming;
  std::uint32_t byte;  // the first of a range, for its module
};

class ImageFaults {
 public:
  using Report = std::function<void(const ImageFault&)>;
  // The images have just been updated: inputs are compared first, then outputs.
  void compare(const Areas& areas, ImageErrors when, const Report& report);

 private:
  Presence inputs_, outputs_;  // faulty bytes at the last update
};

}  // namespace merker::cpu
