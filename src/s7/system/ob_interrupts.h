// What SFC 28 to 34 have in common: the interrupt that OB_NR names, and the answer to a query.
#pragma once

#include "cpu/levels.h"
#include "system/call.h"

namespace merker::system {

constexpr std::uint32_t kWrongOb = 0x8090;

// `find`: of cpu::Interrupts. Null: OB_NR is not the number of such an interrupt.
template <typename A, typename Interrupt>
Interrupt* interruptOf(A& a, Interrupt* (cpu::Interrupts::*find)(std::uint32_t)) {
  const std::int32_t ob = a.integer("OB_NR");
  return ob < 0 ? nullptr : (a.cpu().interrupts().*find)(static_cast<std::uint32_t>(ob));
}

// STATUS: bit 1 locked, 2 active (running), 4 OB loaded.
template <typename A, typename Interrupt>
void answerQuery(A& a, const Interrupt* interrupt) {
  if (interrupt == nullptr) {
    a.set("STATUS", 0);
    return a.status(kWrongOb);
  }
  const bool locked = a.cpu().interrupts().isLocked(interrupt->ob);
  a.set("STATUS",
        locked * 2u | interrupt->active * 4u | cpu::hasOb(a.machine(), interrupt->ob) * 16u);
  a.status(0);
}

}  // namespace merker::system
