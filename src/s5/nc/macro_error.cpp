#include "nc/macro_error.h"

#include "base/bcd.h"

namespace merker::nc {
namespace {

constexpr MacroError kErrors[] = {
#define MACRO_ERROR(macro, number, german, english) {macro, number, german, english},
#include "nc/macro_errors.inc"
#undef MACRO_ERROR
};

}  // namespace

std::span<const MacroError> macroErrors() { return kErrors; }

const MacroError* findMacroError(std::uint32_t akku1, std::uint32_t akku2) {
  for (const MacroError& error : kErrors)
    if (error.macro == akku1 && error.number == (akku2 & 0xFF)) return &error;
  return nullptr;
}

sinumerik::Trap macroTrap(sinumerik::Machine& machine, std::uint16_t macro, std::uint16_t error) {
  if (!machine.levels.empty()) {
    machine.registers().akku1 = macro;
    machine.registers().akku2 = error;
  }
  const auto number = static_cast<std::uint16_t>(toBcd(macro, 4));
  return {sinumerik::Alarm::Macro, {0, error, number}};
}

}  // namespace merker::nc
