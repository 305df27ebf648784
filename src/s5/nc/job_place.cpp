#include "nc/job_place.h"

#include "nc/plc_memory.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;

constexpr unsigned kLowestBlock = 2, kLowestFlag = 136;

std::uint16_t wordAt(Machine& m, Place place, unsigned word) {
  if (place.block == 0) return flagWord(m, place.first + 2 * word);
  return dataBlock(m, place.block)[place.first + word];
}

void setWordAt(Machine& m, Place place, unsigned word, std::uint16_t value) {
  if (place.block == 0) return setFlagWord(m, place.first + 2 * word, value);
  dataBlock(m, place.block)[place.first + word] = value;
}

}  // namespace

bool placeExists(Machine& m, const Job& job) {
  const unsigned words = job.values * wordCount(job.format);
  const unsigned first = job.place.first;
  if (job.place.block == 0) return first >= kLowestFlag && first + 2 * words <= m.flags.size();
  if (job.place.block < kLowestBlock) return false;
  if (first + words > dataBlock(m, job.place.block).size()) return false;
  return job.write || !m.dataInEprom.test(job.place.block);
}

PlcValue readValue(Machine& m, const Job& job, unsigned index) {
  PlcValue value;
  value.count = wordCount(job.format);
  for (unsigned i = 0; i < value.count; ++i)
    value.words.at(i) = wordAt(m, job.place, index * value.count + i);
  return value;
}

void writeValue(Machine& m, const Job& job, unsigned index, PlcValue value) {
  const unsigned first = index * value.count;
  if (value.count == 3) {
    const auto free = wordAt(m, job.place, first) & 0xFF00;
    value.words[0] = static_cast<std::uint16_t>(free | lowByte(value.words[0]));
  }
  for (unsigned i = 0; i < value.count; ++i) setWordAt(m, job.place, first + i, value.words.at(i));
}

}  // namespace merker::nc
