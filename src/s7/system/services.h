// Answers calls of SFC, SFB and of the library functions that the CPU brings.
#pragma once

#include <memory>

#include "block/block.h"
#include "cpu/engine.h"
#include "system/arguments.h"
#include "system/function_table.h"

namespace merker::system {

class Services : public cpu::SystemServices {
 public:
  explicit Services(const CpuModel& model, const Libraries& libraries = standardLibraries());
  bool call(const cpu::SystemCall& call) override;
  bool steady(BlockId block) const override;
  void restart() override;
  Alarms& alarms() { return context_.alarms; }
  Communication& communication() { return context_.communication; }
  void configure(const CommunicationParameters& parameters);
  Connections& connections() { return *context_.connections; }
  SendReceive& sendReceive() { return *context_.sendReceive; }
  BasicCommunication& partners() { return context_.partners; }
  const BasicCommunication& partners() const { return context_.partners; }
  // Whom the functions for modules ask; null: no modules.
  // The sub-module PtP and its address; null: the project has none.
  void connect(serial::Coupling* coupling, std::uint32_t address) {
    context_.serial = coupling;
    context_.serialAddress = address;
  }
  void connect(Modules* modules, technology::Counting* counting,
               positioning::Positioning* positioning) {
    context_.modules = modules;
    context_.counting = counting;
    context_.positioning = positioning;
  }

 private:
  Context context_;
  std::shared_ptr<const FunctionTable> functions_;
};

}  // namespace merker::system
