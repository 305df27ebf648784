#include "cpu/image_faults.h"

#include <algorithm>

namespace merker::cpu {
namespace {

using Bytes = Presence;

// Bytes of the image that belong to a module which does not answer.
Bytes faulty(const Bytes& configured, const Bytes& present, std::uint32_t bytes) {
  Bytes result(configured.empty() ? 0 : bytes);
  for (std::size_t i = 0; i < std::min(result.size(), configured.size()); ++i)
    result[i] = configured[i] && !present[i];
  return result;
}

bool at(const Bytes& bytes, std::size_t index) { return index < bytes.size() && bytes[index]; }

// One call for each range of bytes: its first byte stands for the module.
template <typename Call>
void eachRange(const Bytes& bytes, Call call) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] && (i == 0 || !bytes[i - 1])) call(static_cast<std::uint32_t>(i));
}

void compareSide(Bytes& before, Bytes now, bool output, bool always,
                 const ImageFaults::Report& report) {
  const std::uint8_t faultId = static_cast<std::uint8_t>((always ? 0xB1 : 0xB3) + output);
  Bytes coming(now.size()), going(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    coming[i] = now[i] && (always || !at(before, i));
    going[i] = !always && !now[i] && at(before, i);
  }
  before = std::move(now);
  eachRange(coming, [&](std::uint32_t byte) { report({faultId, true, byte}); });
  eachRange(going, [&](std::uint32_t byte) { report({faultId, false, byte}); });
}

}  // namespace

void ImageFaults::compare(const Areas& areas, ImageErrors when, const Report& report) {
  if (when == ImageErrors::None || areas.inputConfigured.empty()) return;
  const bool always = when == ImageErrors::EachCycle;
  compareSide(inputs_, faulty(areas.inputConfigured, areas.inputPresent, areas.imageBytes), false,
              always, report);
  compareSide(outputs_, faulty(areas.outputConfigured, areas.outputPresent, areas.imageBytes), true,
              always, report);
}

}  // namespace merker::cpu
