#include "io/asi.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "io/rack.h"

namespace merker::io {
namespace {

// AS-Interface complete specification, IO codes 0 to E: a letter for each of D0 to D3, B for both;
// F has none.
constexpr std::string_view kIoCodes[] = {"IIII", "IIIO", "IIIB", "IIOO", "IIBB", "IOOO",
                                         "IBBB", "BBBB", "OOOO", "OOOI", "OOOB", "OOII",
                                         "OOBB", "OIII", "OBBB", "...."};

std::uint8_t bitsOf(std::uint8_t ioCode, char letter) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < kAsiBits; ++i) {
    const char own = kIoCodes[ioCode & 0xF][i];
    if (own == letter || own == 'B') bits |= 1u << i;
  }
  return static_cast<std::uint8_t>(bits);
}

struct AsiType {
  std::string name;
  ModuleType row;
};

std::shared_ptr<const ModuleType> asiType(const AsiSlave& slave) {
  auto own = std::make_shared<AsiType>(AsiType{slave.profile,
                                               {.orderNumber = "AS-i",
                                                .name = {},
                                                .text = {},
                                                .kind = ModuleKind::Digital,
                                                .digitalInputs = kAsiBits,
                                                .digitalOutputs = kAsiBits}});
  own->row.name = own->name;
  return {own, &own->row};
}

Module asiModule(const AsiSlave& slave, const Module& cp, std::uint32_t number) {
  constexpr std::uint32_t kPerRack = 100;
  Module module;
  module.own = asiType(slave);
  module.type = module.own.get();
  module.rack = kAsiRack + kPerRack * cp.rack + cp.slot;
  module.slot = slave.address;
  module.name = slave.name;
  module.position = slave.position;
  module.parameters = Parameters::of(*module.type);
  module.asiCp = number;
  module.asiInputs = asiInputs(slave.ioCode);
  module.asiOutputs = asiOutputs(slave.ioCode);
  return module;
}

}  // namespace

bool isAsiMaster(const ModuleType& type) { return type.name == "CP 343-2"; }
std::uint8_t asiInputs(std::uint8_t ioCode) { return bitsOf(ioCode, 'I'); }
std::uint8_t asiOutputs(std::uint8_t ioCode) { return bitsOf(ioCode, 'O'); }

void addAsiSlaves(Configuration& configuration, Problems& problems) {
  auto& modules = configuration.modules;
  const auto own = static_cast<std::uint32_t>(modules.size());
  for (std::uint32_t i = 0; i < own; ++i) {
    const auto slaves = modules[i].asi;
    if (!slaves) continue;
    for (const AsiSlave& slave : *slaves) {
      const Module added = asiModule(slave, modules[i], i);
      for (const Module& other : modules)
        if (!added.name.empty() && equalsIgnoreCase(added.name, other.name))
          problems.add(ProblemCode::P0742, slave.position, added.name, "slot " + other.slotText());
      modules.push_back(added);
    }
  }
}

// Its four bits among those of the CP.
void Rack::showAsi(std::uint32_t index, std::uint32_t bits) {
  const Module& slave = of(index);
  const std::uint32_t byte = *of(*slave.asiCp).inputStart + asiByte(slave.slot);
  const std::uint32_t shift = asiShift(slave.slot);
  const std::uint32_t others = inputs()[byte] & ~(0xFu << shift);
  inputs_.set(byte, static_cast<std::uint8_t>(others | (bits & slave.asiInputs) << shift));
}

bool Rack::asiOutput(const Module& slave, std::uint32_t channel) const {
  const std::uint32_t byte = *of(*slave.asiCp).outputStart + asiByte(slave.slot);
  const bool used = (slave.asiOutputs >> channel & 1) != 0;
  return used && (outputs_.byte(byte) >> (asiShift(slave.slot) + channel) & 1) != 0;
}

// Slaves that are configured and do not answer, a bit for each address.
std::uint32_t Rack::missingOnAsi(std::uint32_t cp) const {
  std::uint32_t missing = 0;
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (of(i).asiCp == cp && !present(i)) missing |= 1u << of(i).slot;
  return missing;
}

// A slave, or the CP of some: what changes is told by the CP.
void Rack::asiFault(std::uint32_t index, FaultKind kind, bool there) {
  const std::uint32_t cp = of(index).asiCp.value_or(index);
  present_ = presentNow();
  if (index == cp && kind == FaultKind::Removed)
    events_.presence(of(cp), there ? ModuleEvent::Kind::Removed : ModuleEvent::Kind::Inserted);
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (i == index || of(i).asiCp == cp) refresh(i);
  diagnose(cp);
}

}  // namespace merker::io
