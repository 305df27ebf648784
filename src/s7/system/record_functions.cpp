// SFC 54 RD_DPARM, 55 WR_PARM, 56 WR_DPARM, 57 PARM_MOD, 58 WR_REC, 59 RD_REC (S7-SFC-21).
#include <algorithm>

#include "system/records.h"

namespace merker::system {
namespace {

// Writes what RECORD holds. Record 0 is that of the configuration and cannot be written.
template <typename A>
void write(A& a) {
  RecordTarget target = recordTarget(a, a.value("RECNUM"));
  std::vector<std::uint8_t> data;
  if (target.code == 0) target.code = recordBytes(a, a.any("RECORD"), data);
  if (target.code == 0 && target.number == 0) target.code = kUnknownRecord;
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code == 0) code = writeTo(a, target, data);
  answerJob(a, code);
}

// Sends the configured record of this number.
std::uint32_t sendConfigured(Arguments& a, RecordTarget target, std::uint32_t number) {
  target.number = number;
  const auto data =
      a.modules()->configuredRecord(target.module.place, static_cast<std::uint8_t>(number));
  return data ? writeTo(a, target, *data) : kNoSuchParameters;
}

std::uint32_t unconfigured(Arguments& a, const RecordTarget& target) {
  return a.modules()->configuredRecords(target.module.place).empty() ? kNoParameters : 0;
}

}  // namespace

void readConfiguredRecord(Sfc<54>& a) {
  const RecordTarget target = recordTarget(a, a.value("RECNUM"));
  if (target.code != 0) return a.status(target.code);
  if (const auto code = unconfigured(a, target)) return a.status(code);
  const auto data =
      a.modules()->configuredRecord(target.module.place, static_cast<std::uint8_t>(target.number));
  if (!data) return a.status(kNoSuchParameters);
  const AnyPointer where = a.any("RECORD");
  if (where.type != TypeCode::Byte) return a.status(kNotByte);
  if (where.count < data->size()) return a.status(kWrongLength);
  const Region region =
      a.region(where, static_cast<std::uint32_t>(data->size()), cpu::Access::Write);
  if (!region) return a.parameterError("RECORD", region.error);
  std::copy(data->begin(), data->end(), region.data);
  a.status(0);
}

void writeParameters(Sfc<55>& a) { write(a); }
void writeRecord(Sfc<58>& a) { write(a); }

void writeConfiguredRecord(Sfc<56>& a) {
  RecordTarget target = recordTarget(a, a.value("RECNUM"));
  if (target.code == 0) target.code = unconfigured(a, target);
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code == 0) code = sendConfigured(a, target, target.number);
  answerJob(a, code);
}

// All configured records.
void parametrizeModule(Sfc<57>& a) {
  RecordTarget target = recordTarget(a, 0);
  if (target.code == 0) target.code = unconfigured(a, target);
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code == 0)
    for (const std::uint8_t number : a.modules()->configuredRecords(target.module.place))
      if (code == 0) code = sendConfigured(a, target, number);
  answerJob(a, code);
}

// RET_VAL says how many bytes were read if RECORD is longer than the data record.
void readRecord(Sfc<59>& a) {
  RecordTarget target = recordTarget(a, a.value("RECNUM"));
  const AnyPointer where = a.any("RECORD");
  if (target.code == 0 && where.type != TypeCode::Byte) target.code = kNotByte;
  std::uint32_t code = proceed(a, target, a.flag("REQ"));
  if (code != 0) return answerJob(a, code);
  std::vector<std::uint8_t> data;
  code = readFrom(a, target, data);
  const auto length = static_cast<std::uint32_t>(data.size());
  if (code == 0 && where.count < length) code = kWrongLength;
  if (code != 0) return answerJob(a, code);
  a.set("BUSY", 0);
  const Region region = a.region(where, length, cpu::Access::Write);
  if (!region) return a.parameterError("RECORD", region.error);
  std::copy(data.begin(), data.end(), region.data);
  a.status(where.count > length ? length : 0);
}

}  // namespace merker::system
