// Process images to and from the modules (S7-CYCLE-02).
#include "cpu/cpu.h"

namespace merker::cpu {

void Cpu::updateImages() {
  Areas& areas = machine_.areas;
  forces_.apply(areas.image);
  areas.writeOutputs();
  modules_.written(0, areas.imageBytes);
  modules_.reading();
  areas.readInputs();
  imageFaults_.compare(areas, parameters_.imageErrors,
                       [this](const ImageFault& fault) { imageFault(fault); });
  cyclePoints_.reached(CyclePoint::Begin);
  forces_.apply(areas.image);
}

// Bytes 4 and 10 of the start information: access by bytes, address.
void Cpu::imageFault(const ImageFault& fault) {
  if (!state_.executing()) return;
  StartInformation start = startInformation(fault.coming ? 0x39 : 0x38, fault.faultId,
                                            priorityOf(85), 85, log_.dateAndTime());
  constexpr std::uint8_t kByteAccess = 0x10;
  setByte(start, 4, kByteAccess);
  setWord(start, 10, fault.byte);
  requests_.asynchronousError(start);
}

}  // namespace merker::cpu
