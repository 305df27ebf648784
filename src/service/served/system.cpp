#include "served/system.h"

#include <algorithm>

#include "cpu/cpu.h"
#include "cpu/ram_to_rom.h"
#include "cpu/switch_panel.h"
#include "station/block_cpu.h"
#include "system/communication.h"
#include "system/szl.h"

namespace merker::served {
namespace {

using controller::Controller;
using controller::Mode;
using s7comm::Controlled;
using s7comm::Error;

constexpr int kRunLevel = 2;  // write protection (S7-300 Module Data, SZL 0232, sch_rel)

// Null: a machine without SZL and clock.
cpu::Cpu* cpuOf(Controller& plc) {
  auto* const one = controller::capability<station::BlockCpu>(plc);
  return one == nullptr ? nullptr : &one->cpu();
}

Controlled stop(monitor::Monitor& monitor) {
  if (monitor.plc().mode() == Mode::Stop) return Controlled::Already;
  monitor.stop();
  return Controlled::Done;
}

std::optional<cpu::SwitchPosition> switchOf(Controller& plc) {
  const auto* const panel = controller::capability<cpu::SwitchPanel>(plc);
  return panel == nullptr ? std::nullopt : std::optional(panel->switchPosition());
}

// Nobody who is not there turns the switch: STOP there has precedence.
Controlled restart(Controller& plc, bool cold) {
  if (plc.mode() != Mode::Stop) return Controlled::Already;
  if (switchOf(plc) == cpu::SwitchPosition::Stop) return Controlled::Refused;
  if (cold && !plc.hasColdRestart()) return Controlled::Refused;
  return (cold ? plc.coldRestart() : plc.start()) ? Controlled::Done : Controlled::Refused;
}

Controlled copyRamToRom(Controller& plc, std::string_view password) {
  auto* const memory = controller::capability<cpu::RamToRom>(plc);
  const bool copied = memory != nullptr && memory->copyRamToRom(password).empty();
  return copied ? Controlled::Done : Controlled::Refused;
}

Controlled memoryReset(Controller& plc) {
  if (plc.mode() != Mode::Stop || !plc.powered()) return Controlled::Refused;
  plc.memoryReset();
  return Controlled::Done;
}

}  // namespace

// The level in force is the higher one of the parameter and the mode switch, which is 2 at RUN; a
// password, if the CPU has one, opens both.
bool isProtected(Controller& plc, std::string_view password, int level) {
  const cpu::Cpu* const cpu = cpuOf(plc);
  if (cpu == nullptr) return false;
  const bool locked = switchOf(plc) == cpu::SwitchPosition::Run;
  const int inForce = std::max<int>(cpu->parameters().protection, locked ? kRunLevel : 0);
  const std::string_view wanted = cpu->parameters().password;
  return inForce >= level && (wanted != password || wanted.empty());
}

bool mayLoad(Controller& plc, std::string_view password) { return !isProtected(plc, password); }

s7comm::StatusList statusList(Controller& plc, std::uint16_t list, std::uint16_t index) {
  auto* const one = controller::capability<station::BlockCpu>(plc);
  if (one == nullptr) return {};
  const system::SzlList found = one->systemStatus(list, index);
  if (found.error == system::kSzlUnknown) return {};
  if (found.error != 0) return {.error = Error::NoInformation};
  return {Error::None, found.recordLength, found.records, found.data};
}

void setConnections(Controller& plc, const Resources::Counts& inUse,
                    const std::optional<system::EthernetInterface>& ethernet) {
  auto* const one = controller::capability<station::BlockCpu>(plc);
  if (one == nullptr) return;
  one->communication().used = inUse;
  one->communication().ethernet = ethernet;
}

void setTestJobs(Controller& plc, std::size_t jobs) {
  if (auto* const one = controller::capability<station::BlockCpu>(plc))
    one->communication().testJobs = static_cast<std::uint32_t>(jobs);
}

std::optional<s7comm::ClockTime> clockOf(Controller& plc) {
  const cpu::Cpu* const cpu = cpuOf(plc);
  if (cpu == nullptr) return std::nullopt;
  return cpu::toDateAndTime(cpu->clock().milliseconds(plc.now()));
}

Error setClock(Controller& plc, const s7comm::ClockTime& time, std::string_view password) {
  cpu::Cpu* const cpu = cpuOf(plc);
  if (cpu == nullptr) return Error::FunctionNotAvailable;
  if (isProtected(plc, password)) return Error::NeedsPassword;
  const auto milliseconds = cpu::fromDateAndTime(time.data());
  if (!milliseconds) return Error::WrongTime;
  cpu->setClock(*milliseconds);
  return Error::None;
}

Error checkPassword(Controller& plc, std::string_view password) {
  const cpu::Cpu* const cpu = cpuOf(plc);
  if (cpu == nullptr || cpu->parameters().password.empty()) return Error::NoPassword;
  return cpu->parameters().password == password ? Error::None : Error::WrongPassword;
}

Controlled control(monitor::Monitor& monitor, s7comm::Control wish, std::string_view password) {
  using s7comm::Control;
  Controller& plc = monitor.plc();
  if (isProtected(plc, password)) return Controlled::Protected;
  switch (wish) {
    case Control::Stop:
      return stop(monitor);
    case Control::WarmRestart:
    case Control::ColdRestart:
      return restart(plc, wish == Control::ColdRestart);
    case Control::CopyRamToRom:
      return copyRamToRom(plc, password);
    case Control::Compress:  // there are no gaps
      return cpuOf(plc) == nullptr ? Controlled::Refused : Controlled::Done;
    case Control::MemoryReset:
      return memoryReset(plc);
  }
  return Controlled::Refused;
}

}  // namespace merker::served
