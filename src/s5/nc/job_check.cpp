// The errors that FB 61 and FB 62 find in their parameters.
#include "nc/job.h"
#include "nc/job_place.h"

namespace merker::nc {
namespace {

constexpr int kMostValues = 80;
constexpr int kCoarse = 0, kFine = 1;

std::optional<JobError> checkNumber(const DataType& type, int count) {
  const int most = static_cast<int>(type.most);
  if (count < 1 || (count > kMostValues && count > most)) return JobError::Number;
  if (count <= most) return std::nullopt;
  return type.most == 1 ? JobError::NumberAboveOne : JobError::Number;
}

// ZOA and ZOFA: coarse or fine. What other values are beyond their limits the NC refuses.
bool wrongThird(const DataType& type, const Where& where) {
  return type.limits[2].used() && type.content == Content::Position && where[2] != kCoarse &&
         where[2] != kFine;
}

std::optional<JobError> check(const Request& request, const Job& job, sinumerik::Machine& m) {
  if (job.type == nullptr) return JobError::Type;
  const DataType& type = *job.type;
  const FormatSet formats = job.write ? type.write : type.read;
  if (formats == 0) return JobError::Direction;
  if (const auto error = checkNumber(type, request.count)) return error;
  const auto format = parseFormat(request.format);
  if (!format || (formats & only(*format)) == 0) return JobError::Format;
  if (wrongThird(type, request.where)) return JobError::CoarseOrFine;
  if (!placeExists(m, job)) return JobError::Place;
  return std::nullopt;
}

}  // namespace

Checked makeJob(const Request& request, sinumerik::Machine& m, Model model) {
  Job job;
  job.write = request.write;
  job.interfaceByte = request.interfaceByte.value_or(0);
  job.type = findDataType(request.type, request.where, model);
  job.where = request.where;
  if (job.type != nullptr) job.values = static_cast<unsigned>(request.count) * job.type->each;
  job.format = parseFormat(request.format).value_or(Format::F0);
  job.place = {static_cast<std::uint8_t>(request.place >> 8),
               static_cast<std::uint8_t>(request.place)};
  return {job, check(request, job, m)};
}

}  // namespace merker::nc
