#include "system/services.h"

#include <algorithm>

#include "system/connections.h"
#include "system/send_receive.h"

namespace merker::system {

Services::Services(const CpuModel& model, const Libraries& libraries)
    : functions_(functionTable(model, libraries)) {
  context_.communication.parameters = CommunicationParameters::of(model);
  context_.connections = std::make_shared<Connections>();
  context_.sendReceive = std::make_shared<SendReceive>();
}

void Services::restart() {
  context_.jobs.clear();
  context_.alarms.clear();
  context_.absentSerial.reset();
  context_.partners.restart();
  context_.connections->restart();
  context_.sendReceive->restart();
}

void Services::configure(const CommunicationParameters& parameters) {
  context_.communication.parameters = parameters;
  context_.connections->configure(parameters.configured);
  context_.sendReceive->configure(parameters.ofCp);
}

namespace {

struct SteadyRow {
  BlockKind kind;
  std::uint16_t first, last;
};
// Functions of their parameters and of memory alone. The IEC timers look at the system time, and
// say so. Everything else asks the operating system or modules, or acts on them.
constexpr SteadyRow kSteady[] = {{BlockKind::FC, 0, UINT16_MAX},
                                 {BlockKind::SFC, 20, 21},   // BLKMOV, FILL
                                 {BlockKind::SFC, 81, 81},   // UBLKMOV
                                 {BlockKind::SFB, 0, 5},     // CTU, CTD, CTUD, TP, TON, TOF
                                 {BlockKind::SFB, 49, 49}};  // tells what it changes

}  // namespace

bool Services::steady(BlockId block) const {
  const FunctionTable::Entry* const entry = functions_->find(block);
  if (entry != nullptr && entry->function->library == BlockLibrary::NetCp) return false;
  return std::ranges::any_of(kSteady, [&](const SteadyRow& row) {
    return row.kind == block.kind && row.first <= block.number && block.number <= row.last;
  });
}

// BIE tells whether it went well (S7-SFC-01).
bool Services::call(const cpu::SystemCall& call) {
  const FunctionTable::Entry* const entry = functions_->find(call.block);
  if (entry == nullptr) return false;
  // UC FC n means a block of the program: library functions are called with parameters
  if (call.block.kind == BlockKind::FC && call.parameters.empty()) return false;
  call.machine.registers.status.br =
      entry->function->run({call, *entry->function, entry->places, context_});
  return true;
}

}  // namespace merker::system
