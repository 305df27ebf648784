#include "cpu/modules.h"

#include <algorithm>

namespace merker::cpu {

void Modules::connect(Periphery* periphery) {
  periphery_ = periphery;
  if (periphery_ != nullptr) periphery_->disableOutputs(*machine_.cpu, outputsDisabled_);
}

bool Modules::advance() {
  if (next() > machine_.clock) return true;
  hang_ = !atOnce_.moves(machine_.clock);
  if (!hang_) periphery_->advance(*machine_.cpu, machine_.clock);
  count(hang_ ? Periphery::Notice::Anyhow : periphery_->noticed());
  return !hang_;
}

void Modules::count(Periphery::Notice notice) {
  if (notice == Periphery::Notice::Anyhow) ++acts_;
  if (notice == Periphery::Notice::ByAccess) ++actsByAccess_;
}

void Modules::written(std::uint32_t first, std::uint32_t count) {
  if (periphery_ == nullptr) return;
  periphery_->written(*machine_.cpu, first, count);
  machine_.horizon = std::min(machine_.horizon, next());
}

void Modules::disableOutputs(bool disabled) {
  if (outputsDisabled_ == disabled) return;
  outputsDisabled_ = disabled;
  if (periphery_ != nullptr) periphery_->disableOutputs(*machine_.cpu, disabled);
}

void Modules::acknowledge(std::uint32_t address) {
  if (periphery_ != nullptr) periphery_->acknowledged(*machine_.cpu, address);
}

void Modules::modeChanged() {
  if (periphery_ != nullptr) periphery_->modeChanged(*machine_.cpu);
}

void Modules::started() {
  if (periphery_ != nullptr) periphery_->started(*machine_.cpu);
}

void Modules::supply(bool on) {
  if (periphery_ != nullptr) periphery_->supply(*machine_.cpu, on);
}

}  // namespace merker::cpu
