// The modules as the operating system sees them: the seam Periphery with the line "output disable".
// Without a Periphery the terminals are what stands in Areas::inputs and outputs.
#pragma once

#include <cstdint>
#include <string_view>

#include "clock/standstill.h"
#include "cpu/machine.h"
#include "cpu/periphery.h"

namespace merker::cpu {

class Modules {
 public:
  explicit Modules(Machine& machine) : machine_(machine) {}
  void connect(Periphery* periphery);  // null: none
  bool connected() const { return periphery_ != nullptr; }

  // When they act by themselves next.
  Instant next() const {
    return periphery_ == nullptr || hang_ ? Instant::never() : periphery_->next();
  }
  // Lets them act now. False: they want this instant again and again, and time would never go on;
  // they are not asked again until `wake`.
  bool advance();
  void wake() { hang_ = false; }
  // As Periphery says.
  Instant nextVisible(bool access) const {
    return periphery_ == nullptr || hang_ ? Instant::never() : periphery_->nextVisible(access);
  }
  void passed() {
    if (periphery_ != nullptr) periphery_->passed(*machine_.cpu, machine_.clock);
  }
  // How often they have done something that the CPU can notice.
  std::uint64_t acts(bool access) const { return access ? acts_ + actsByAccess_ : acts_; }
  // As Periphery says.
  bool steady() const { return periphery_ == nullptr || periphery_->steady(); }
  std::string_view due() const { return periphery_->due(machine_.clock); }

  // Areas::inputs are about to be read.
  void reading() {
    if (periphery_ != nullptr) periphery_->reading(*machine_.cpu);
  }
  // The program or the process image wrote outputs.first .. first + count - 1.
  void written(std::uint32_t first, std::uint32_t count);
  void disableOutputs(bool disabled);  // S7-STATE-02, -11
  bool outputsDisabled() const { return outputsDisabled_; }

  // Each as Periphery says.
  void acknowledge(std::uint32_t address);
  void modeChanged();
  void started();
  void supply(bool on);

 private:
  Machine& machine_;
  Periphery* periphery_ = nullptr;
  bool outputsDisabled_ = true;
  bool hang_ = false;
  std::uint64_t acts_ = 0, actsByAccess_ = 0;
  void count(Periphery::Notice notice);
  Standstill atOnce_{1000};
};

}  // namespace merker::cpu
