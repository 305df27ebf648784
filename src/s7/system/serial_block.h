// What SFB 60 to 65 have in common: the sub-module that LADDR names, SD_1 and RD_1, and the outputs
// (technology manual 6.5; PTP-SFBG).
#pragma once

#include "serial/coupling.h"
#include "system/call.h"
#include "system/serial_memory.h"

namespace merker::system {

// Of the sub-module; of one that nobody can use if the project has none (PTP-ERR-04).
serial::Coupling& couplingOf(Arguments& a);
// Whether LADDR is its address and the protocol the right one (PTP-SFBG-11, -12).
bool serialPermitted(Arguments& a, std::uint32_t address, bool computerLink);
// The instance that is called; those within another one differ, too.
std::uint32_t serialInstance(Arguments& a);
// The driver begins with what it got; its line goes on (PTP-LINE-02).
void serialChanged(Arguments& a);

// An area other than a data block is a programming error (PTP-SFBG-05).
serial::Place serialPlace(Arguments& a, const AnyPointer& where, bool used, cpu::Access access);

// `rk`: a block of RK 512.
template <typename A>
serial::Control serialControl(A& a, NameIn<A> request, bool rk) {
  couplingOf(a).advance(a.machine().clock);
  return {.instance = serialInstance(a),
          .request = a.flag(request),
          .reset = a.flag("R"),
          .permitted = serialPermitted(a, a.value("LADDR"), rk)};
}

// `done`: DONE or NDR.
template <typename A>
void showSerial(A& a, NameIn<A> done, const serial::Answer& answer) {
  a.set(done, answer.done);
  a.set("ERROR", answer.error);
  a.set("STATUS", static_cast<std::uint32_t>(answer.status));
  if (answer.error) a.fail();  // PTP-SFBG-06
  serialChanged(a);
}

}  // namespace merker::system
