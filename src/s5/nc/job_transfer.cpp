// A job that is due: values from the NC to the PLC or back.
#include "nc/job.h"
#include "nc/job_place.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;

// WER1 … WER3 of one value of the job.
Where whereOf(const Job& job, unsigned index) {
  Where where = job.where;
  if (job.type->counted != 0) where.at(job.type->counted - 1) += static_cast<int>(index);
  return where;
}

// All values must exist in the NC before the first one is moved (S5-FM-28).
bool allExist(const Job& job) {
  return withinLimits(*job.type, whereOf(job, 0)) &&
         withinLimits(*job.type, whereOf(job, job.values - 1));
}

Result readOne(const Job& job, unsigned index, const Control& control, Machine& m) {
  const DataType& type = *job.type;
  const auto number = type.get(control, whereOf(job, index), index);
  if (!number) return Result::Refused;
  const auto value = encode(*number, job.format, type.content, control.inputSystem);
  if (!value) return job.format == Format::BI ? Result::WrongFormat : Result::Refused;
  writeValue(m, job, index, *value);
  return Result::Done;
}

Result writeOne(const Job& job, unsigned index, Control& control, Machine& m) {
  const DataType& type = *job.type;
  const PlcValue value = readValue(m, job, index);
  const auto number = decode(value.words, job.format, type.content, control.inputSystem);
  const bool taken = number && type.put(control, whereOf(job, index), *number);
  return taken ? Result::Done : Result::Refused;
}

}  // namespace

Result execute(const Job& job, Control& control, Machine& m) {
  if (!placeExists(m, job)) return Result::NoPlace;
  if (!allExist(job)) return Result::Refused;
  for (unsigned i = 0; i < job.values; ++i) {
    const Result result = job.write ? writeOne(job, i, control, m) : readOne(job, i, control, m);
    if (result != Result::Done) return result;
  }
  return Result::Done;
}

}  // namespace merker::nc
