#include "profibus/slave_diagnosis.h"

namespace merker::profibus {
namespace {

// Station status 1 and 2; bit 2 of the second is always 1.
constexpr std::uint8_t kDoesNotExist = 0x01, kHasDiagnosis = 0x08;
constexpr std::uint8_t kIsSlave = 0x04, kWatchdog = 0x08;
constexpr std::uint8_t kNoMaster = 0xFF;
constexpr std::uint8_t kIdentifierRelated = 0x40;  // header; its length with itself in bits 0 to 5

bool headAnswers(const io::Rack& rack, const io::Slave& slave) {
  const auto head = rack.module(slave.name);
  return head && rack.present(*head);
}

}  // namespace

std::vector<std::uint8_t> slaveDiagnosis(const io::Rack& rack, const io::Slave& slave) {
  std::vector<std::uint8_t> data{0,
                                 kIsSlave | kWatchdog,
                                 0,
                                 rack.configuration().dp->address,
                                 static_cast<std::uint8_t>(slave.ident >> 8),
                                 static_cast<std::uint8_t>(slave.ident)};
  if (!headAnswers(rack, slave)) {
    data[0] |= kDoesNotExist;
    data[1] = kIsSlave;
    data[3] = kNoMaster;
    return data;
  }
  std::vector<std::uint8_t> bits((slave.modules.size() + 7) / 8);
  bool any = false;
  for (std::size_t i = 0; i < slave.modules.size(); ++i) {
    const auto module = rack.module(slave.modules[i].slotText());
    if (!module || !rack.faulty(*module)) continue;
    bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | 1u << (i % 8));
    any = true;
  }
  if (!any) return data;
  data[0] |= kHasDiagnosis;
  data.push_back(static_cast<std::uint8_t>(kIdentifierRelated | (bits.size() + 1)));
  data.insert(data.end(), bits.begin(), bits.end());
  return data;
}

}  // namespace merker::profibus
