// The operand areas of a CPU: process image, flags and periphery. Inputs, outputs and flags lie one
// behind the other in `image`, so that an engine reaches each of them with one offset.
#pragma once

#include <cstdint>
#include <vector>

#include "address/area.h"
#include "catalogue/cpu_model.h"

namespace merker::cpu {

// Where E, A and M begin in `Areas::image`, and how long they are (0: another area).
constexpr std::uint32_t imageBase(const CpuModel& model, Area area) {
  return area == Area::Flag ? 2 * model.imageBytes : area == Area::Output ? model.imageBytes : 0;
}
constexpr std::uint32_t imageLength(const CpuModel& model, Area area) {
  if (area == Area::Input || area == Area::Output) return model.imageBytes;
  return area == Area::Flag ? model.flagBytes : 0;
}

// Of each byte of an address area: does something answer? A byte each, for it is asked for whole
// images in every cycle.
using Presence = std::vector<std::uint8_t>;

struct Areas {
  explicit Areas(const CpuModel& model);

  std::vector<std::uint8_t> image;  // E, A, M
  std::uint32_t imageBytes = 0, flagBytes = 0;
  std::uint32_t outputBase = 0, flagBase = 0;

  // Periphery: what the modules' terminals show. A byte without module does not answer
  // (S7-OPND-11).
  std::vector<std::uint8_t> inputs, outputs;
  Presence inputPresent, outputPresent;
  // Bytes that belong to a configured module, whether it answers or not; empty without a hardware
  // configuration.
  Presence inputConfigured, outputConfigured;

  std::uint8_t* input(std::uint32_t byte) { return &image[byte]; }
  std::uint8_t* output(std::uint32_t byte) { return &image[outputBase + byte]; }
  std::uint8_t* flag(std::uint32_t byte) { return &image[flagBase + byte]; }

  // Length of E, A, M in bytes and where it begins in `image`; 0 for other areas.
  std::uint32_t length(Area area) const;
  std::uint32_t base(Area area) const;

  bool answers(const Presence& present, std::uint32_t byte, unsigned count) const;
  void readInputs();    // terminals to input image; bytes of no module stay as they are
  void writeOutputs();  // output image to terminals
  void clearImages();
};

}  // namespace merker::cpu
