#include "control/plc_options.h"

namespace merker::cnc {
namespace {

void put(sinumerik::MachineData& data, MachineDatum datum) {
  if (datum.number == kSamplingDatum) {
    data.samplingCode = static_cast<std::uint8_t>(datum.value);
    return;
  }
  if (data.setWord(datum.number, datum.value)) return;
  for (unsigned bit = 0; bit < 8; ++bit) data.setBit({datum.number, bit}, datum.value >> bit & 1);
}

}  // namespace

sinumerik::Options plcOptions(const Options& options) {
  sinumerik::Options plc = options.plc;
  plc.variant = options.model->acop ? mc5::Variant::Acop : mc5::Variant::Cop;
  if (options.machineData.empty() && options.bits == sinumerik::BitMapping::Table) return plc;
  const bool alarmLevel = plc.program.contains({mc5::BlockType::Ob, 2});
  plc.machineData = sinumerik::MachineData::standard(alarmLevel);
  plc.machineData->mapping = options.bits;
  for (const MachineDatum& datum : options.machineData) put(*plc.machineData, datum);
  return plc;
}

}  // namespace merker::cnc
