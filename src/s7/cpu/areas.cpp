#include "cpu/areas.h"

#include <algorithm>
#include <cstring>

namespace merker::cpu {
namespace {

struct Range {
  std::uint32_t first, last;
};

// On-board addresses of a 314C (S7-CPU-18) beyond its process image; the image itself always
// answers, as in the S7 simulator: docs/compatibility.md, "periphery without hardware
// configuration".
constexpr Range kInputs[] = {{752, 761}, {768, 783}, {784, 799}};
constexpr Range kOutputs[] = {{752, 755}, {768, 783}, {784, 799}};

void mark(Presence& present, Range range) {
  const std::size_t end = std::min<std::size_t>(range.last + 1, present.size());
  if (range.first < end) std::fill(&present[range.first], present.data() + end, true);
}

constexpr std::size_t kTogether = sizeof(std::uint64_t);

// From a byte of the image on; at most kTogether bytes, and as many as the compiler knows.
inline void readTogether(Areas& areas, std::size_t first, std::size_t count) {
  constexpr std::uint64_t kWholeByte = 0xFF;
  std::uint64_t to = 0, from = 0, present = 0, configured = 0;
  std::memcpy(&configured, &areas.inputConfigured[first], count);
  if (configured == 0) return;
  std::memcpy(&to, &areas.image[first], count);
  std::memcpy(&from, &areas.inputs[first], count);
  std::memcpy(&present, &areas.inputPresent[first], count);
  const std::uint64_t theirs = configured * kWholeByte;  // each byte is 0 or 1: nothing is carried
  to = (to & ~theirs) | (from & present * kWholeByte & theirs);
  std::memcpy(&areas.image[first], &to, count);
}

}  // namespace

Areas::Areas(const CpuModel& model)
    : image(2 * model.imageBytes + model.flagBytes),
      imageBytes(model.imageBytes),
      flagBytes(model.flagBytes),
      outputBase(model.imageBytes),
      flagBase(2 * model.imageBytes),
      inputs(model.peripheralBytes),
      outputs(model.peripheralBytes),
      inputPresent(model.peripheralBytes, model.allPeripheral),
      outputPresent(model.peripheralBytes, model.allPeripheral) {
  mark(inputPresent, {0, imageBytes - 1});
  mark(outputPresent, {0, imageBytes - 1});
  for (const Range& range : kInputs) mark(inputPresent, range);
  for (const Range& range : kOutputs) mark(outputPresent, range);
}

std::uint32_t Areas::length(Area area) const {
  if (area == Area::Input || area == Area::Output) return imageBytes;
  return area == Area::Flag ? flagBytes : 0;
}

std::uint32_t Areas::base(Area area) const {
  if (area == Area::Output) return outputBase;
  return area == Area::Flag ? flagBase : 0;
}

bool Areas::answers(const Presence& present, std::uint32_t byte, unsigned count) const {
  for (unsigned i = 0; i < count; ++i)
    if (byte + i >= present.size() || !present[byte + i]) return false;
  return true;
}

// A module that does not answer delivers 0; addresses of no module are free for the program.
void Areas::readInputs() {
  const std::size_t count = std::min<std::size_t>(imageBytes, inputs.size());
  if (inputConfigured.empty()) {
    std::copy_n(inputs.begin(), count, image.begin());
    return;
  }
  const std::size_t end = std::min(count, inputConfigured.size());
  std::size_t i = 0;
  for (; i + kTogether <= end; i += kTogether) readTogether(*this, i, kTogether);
  if (i < end) readTogether(*this, i, end - i);
}

void Areas::writeOutputs() {
  const std::size_t count = std::min<std::size_t>(imageBytes, outputs.size());
  std::copy_n(image.begin() + outputBase, count, outputs.begin());
}

void Areas::clearImages() { std::fill_n(image.begin(), flagBase, std::uint8_t{0}); }

}  // namespace merker::cpu
