// The operating state of the control, and what a STOP shows.
#include "base/text.h"
#include "control/cnc.h"
#include "softplc/stack_fields.h"

namespace merker::cnc {

using controller::Mode;

Mode Cnc::mode() const {
  switch (plc().mode()) {
    case sinumerik::Mode::Startup:
      return Mode::Startup;
    case sinumerik::Mode::Run:
      return Mode::Run;
    case sinumerik::Mode::Halt:
      return Mode::Halt;
    default:
      return Mode::Stop;
  }
}

bool Cnc::stoppedByFault() const { return plc().stoppedByFault(); }
std::string Cnc::stopReason() const {
  return powered() ? plc().stopReason() : "the control is switched off";
}
bool Cnc::powered() const { return plc().mode() != sinumerik::Mode::Off; }

std::optional<std::string> Cnc::stackField(std::string_view stack, std::string_view field) const {
  const sinumerik::OperatingSystem& os = plc().operatingSystem();
  if (equalsIgnoreCase(stack, "USTACK")) return sinumerik::interruptField(os, field);
  return equalsIgnoreCase(stack, "BSTACK") ? sinumerik::blockField(os, field) : std::nullopt;
}

std::string Cnc::stackFields(std::string_view stack) const {
  if (equalsIgnoreCase(stack, "USTACK")) return sinumerik::interruptFields();
  return equalsIgnoreCase(stack, "BSTACK") ? sinumerik::blockFields() : std::string();
}

std::string Cnc::stopDetails() const {
  const bool stopped = plc().mode() == sinumerik::Mode::Stop;
  return stopped ? sinumerik::stopLine(plc().operatingSystem()) : std::string();
}

}  // namespace merker::cnc
