// SFC 54 RD_DPARM, 55 WR_PARM, 56 WR_DPARM, 57 PARM_MOD, 58 WR_REC, 59 RD_REC (S7-SFC-21).
#include <algorithm>

#include "system/records.h"

namespace merker::system {
namespace {

// Ends the call: BUSY says whether the job goes on.
void answer(Arguments& a, std::size_t busy, std::uint32_t code) {
  a.set(busy, code == kJobBegins);
  a.status(code);
}

// Writes what RECORD holds. Record 0 is that of the configuration and cannot be written.
void write(Arguments& a, std::uint16_t function) {
  enum { REQ, IOID, LADDR, RECNUM, RECORD, BUSY };
  RecordTarget target = recordTarget(a, function, a.value(IOID), a.value(LADDR), a.value(RECNUM));
  std::vector<std::uint8_t> data;
  if (target.code == 0) target.code = recordBytes(a, RECORD, data);
  if (target.code == 0 && target.number == 0) target.code = kUnknownRecord;
  std::uint32_t code = proceed(a, target, a.flag(REQ));
  if (code == 0) code = writeTo(a, target, data);
  answer(a, BUSY, code);
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

void readConfiguredRecord(Arguments& a) {
  enum { IOID, LADDR, RECNUM, RECORD };
  const RecordTarget target = recordTarget(a, 54, a.value(IOID), a.value(LADDR), a.value(RECNUM));
  if (target.code != 0) return a.status(target.code);
  if (const auto code = unconfigured(a, target)) return a.status(code);
  const auto data =
      a.modules()->configuredRecord(target.module.place, static_cast<std::uint8_t>(target.number));
  if (!data) return a.status(kNoSuchParameters);
  const AnyPointer where = a.any(RECORD);
  if (where.type != TypeCode::Byte) return a.status(kNotByte);
  if (where.count < data->size()) return a.status(kWrongLength);
  const Region region =
      a.region(where, static_cast<std::uint32_t>(data->size()), cpu::Access::Write);
  if (!region) return a.parameterError(RECORD, region.error);
  std::copy(data->begin(), data->end(), region.data);
  a.status(0);
}

void writeParameters(Arguments& a) { write(a, 55); }
void writeRecord(Arguments& a) { write(a, 58); }

void writeConfiguredRecord(Arguments& a) {
  enum { REQ, IOID, LADDR, RECNUM, BUSY };
  RecordTarget target = recordTarget(a, 56, a.value(IOID), a.value(LADDR), a.value(RECNUM));
  if (target.code == 0) target.code = unconfigured(a, target);
  std::uint32_t code = proceed(a, target, a.flag(REQ));
  if (code == 0) code = sendConfigured(a, target, target.number);
  answer(a, BUSY, code);
}

// All configured records.
void parametrizeModule(Arguments& a) {
  enum { REQ, IOID, LADDR, BUSY };
  RecordTarget target = recordTarget(a, 57, a.value(IOID), a.value(LADDR), 0);
  if (target.code == 0) target.code = unconfigured(a, target);
  std::uint32_t code = proceed(a, target, a.flag(REQ));
  if (code == 0)
    for (const std::uint8_t number : a.modules()->configuredRecords(target.module.place))
      if (code == 0) code = sendConfigured(a, target, number);
  answer(a, BUSY, code);
}

// RET_VAL says how many bytes were read if RECORD is longer than the data record.
void readRecord(Arguments& a) {
  enum { REQ, IOID, LADDR, RECNUM, BUSY, RECORD };
  RecordTarget target = recordTarget(a, 59, a.value(IOID), a.value(LADDR), a.value(RECNUM));
  const AnyPointer where = a.any(RECORD);
  if (target.code == 0 && where.type != TypeCode::Byte) target.code = kNotByte;
  std::uint32_t code = proceed(a, target, a.flag(REQ));
  if (code != 0) return answer(a, BUSY, code);
  std::vector<std::uint8_t> data;
  code = readFrom(a, target, data);
  const auto length = static_cast<std::uint32_t>(data.size());
  if (code == 0 && where.count < length) code = kWrongLength;
  if (code != 0) return answer(a, BUSY, code);
  a.set(BUSY, 0);
  const Region region = a.region(where, length, cpu::Access::Write);
  if (!region) return a.parameterError(RECORD, region.error);
  std::copy(data.begin(), data.end(), region.data);
  a.status(where.count > length ? length : 0);
}

}  // namespace merker::system
