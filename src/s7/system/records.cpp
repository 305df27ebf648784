#include "system/records.h"

namespace merker::system {

RecordTarget recordTarget(Arguments& a, std::uint32_t area, std::uint32_t address,
                          std::uint32_t number) {
  RecordTarget target{
      .module = {}, .number = number, .job = {a.functionNumber(), area << 16 | address, number}};
  const auto module = moduleAt(a.modules(), area, address, AddressRule::Base);
  if (!module)
    target.code = kUnknownAddress;
  else
    target.module = *module;
  if (target.code == 0) target.code = refusal(target.module);
  if (target.code == 0 && number > kHighestRecord) target.code = kUnknownRecord;
  return target;
}

std::uint32_t proceed(Arguments& a, const RecordTarget& target, bool request) {
  Jobs& jobs = a.jobs();
  if (jobs.end(target.job)) return target.code;
  if (!request) return kNoJob;
  if (target.code != 0) return target.code;
  if (jobs.full()) return kTooManyJobs;
  jobs.begin(target.job);
  return kJobBegins;
}

std::uint32_t readFrom(Arguments& a, const RecordTarget& target, std::vector<std::uint8_t>& data) {
  const RecordResult result =
      a.modules()->readRecord(target.module.place, static_cast<std::uint8_t>(target.number), data);
  return result == RecordResult::NotAcknowledged ? kNotRead : static_cast<std::uint32_t>(result);
}

std::uint32_t writeTo(Arguments& a, const RecordTarget& target,
                      const std::vector<std::uint8_t>& data) {
  return static_cast<std::uint32_t>(a.modules()->writeRecord(
      target.module.place, static_cast<std::uint8_t>(target.number), data));
}

std::uint32_t recordBytes(Arguments& a, const AnyPointer& where, std::vector<std::uint8_t>& data) {
  if (where.type != TypeCode::Byte) return kNotByte;
  const Region region = a.region(where, where.count, cpu::Access::Read);
  if (!region) return kWrongLength;
  data.assign(region.data, region.data + where.count);
  return 0;
}

}  // namespace merker::system
