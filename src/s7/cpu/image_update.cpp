// Process images to and from the modules (S7-CYCLE-02), and what happens when a module does not
// answer (S7-OBI-10).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {

void Cpu::reached(CyclePoint point) {
  if (monitor_) monitor_(point);
}

void Cpu::applyForces() {
  for (const Force& force : forces_) {
    std::uint8_t& byte = machine_.areas.image[force.byte];
    byte = static_cast<std::uint8_t>((byte & ~force.mask) | (force.value & force.mask));
  }
}

void Cpu::updateImages() {
  Areas& areas = machine_.areas;
  applyForces();
  areas.writeOutputs();
  outputsWritten(0, areas.imageBytes);
  aboutToReadInputs();
  areas.readInputs();
  imageErrors();
  reached(CyclePoint::Begin);
  applyForces();
}

void Cpu::outputsWritten(std::uint32_t first, std::uint32_t count) {
  if (periphery_ == nullptr) return;
  periphery_->written(*this, first, count);
  machine_.horizon = std::min(machine_.horizon, nextOfModules());
}

// S7-STATE-02, -11: the line "output disable". Without modules the terminals are Areas::outputs.
void Cpu::disableOutputs(bool disabled) {
  if (outputsDisabled_ == disabled) return;
  outputsDisabled_ = disabled;
  if (periphery_ != nullptr) periphery_->disableOutputs(*this, disabled);
}

namespace {

// Bytes of the image that belong to a module which does not answer.
std::vector<bool> faulty(const std::vector<bool>& configured, const std::vector<bool>& present,
                         std::uint32_t bytes) {
  std::vector<bool> result(configured.empty() ? 0 : bytes);
  for (std::size_t i = 0; i < std::min(result.size(), configured.size()); ++i)
    result[i] = configured[i] && !present[i];
  return result;
}

bool at(const std::vector<bool>& bytes, std::size_t index) {
  return index < bytes.size() && bytes[index];
}

// One call for each range of bytes: its first byte stands for the module.
template <typename Report>
void eachRange(const std::vector<bool>& bytes, Report report) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] && (i == 0 || !bytes[i - 1])) report(static_cast<std::uint32_t>(i));
}

}  // namespace

void Cpu::compareImageErrors(std::vector<bool>& before, std::vector<bool> now, bool output) {
  const bool always = parameters_.imageErrors == ImageErrors::EachCycle;
  const std::uint8_t faultId = static_cast<std::uint8_t>((always ? 0xB1 : 0xB3) + output);
  std::vector<bool> coming(now.size()), going(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    coming[i] = now[i] && (always || !at(before, i));
    going[i] = !always && !now[i] && at(before, i);
  }
  before = std::move(now);
  eachRange(coming, [&](std::uint32_t byte) { imageError(faultId, true, byte); });
  eachRange(going, [&](std::uint32_t byte) { imageError(faultId, false, byte); });
}

void Cpu::imageErrors() {
  const Areas& areas = machine_.areas;
  if (parameters_.imageErrors == ImageErrors::None || areas.inputConfigured.empty()) return;
  compareImageErrors(inputFaulty_,
                     faulty(areas.inputConfigured, areas.inputPresent, areas.imageBytes), false);
  compareImageErrors(outputFaulty_,
                     faulty(areas.outputConfigured, areas.outputPresent, areas.imageBytes), true);
}

// Bytes 4 and 10 of the start information: access by bytes, address.
void Cpu::imageError(std::uint8_t faultId, bool coming, std::uint32_t byte) {
  if (!executes(mode_)) return;
  StartInformation start =
      startInformation(coming ? 0x39 : 0x38, faultId, priorityOf(85), 85, dateAndTime());
  constexpr std::uint8_t kByteAccess = 0x10;
  setByte(start, 4, kByteAccess);
  setWord(start, 10, byte);
  asynchronousError(start);
}

}  // namespace merker::cpu
