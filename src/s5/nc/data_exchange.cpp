#include "nc/data_exchange.h"

#include <algorithm>

#include "nc/plc_memory.h"

namespace merker::nc {
namespace {

using sinumerik::Machine;
using sinumerik::Trap;

constexpr std::uint16_t kWrongValue = 3016;  // NC alarm (S5-FM-35)

std::uint16_t errorWord(unsigned interfaceByte, JobError error) {
  return static_cast<std::uint16_t>(interfaceByte << 8 | static_cast<unsigned>(error));
}

}  // namespace

std::optional<Trap> DataExchange::call(bool write, Machine& m, std::span<const std::uint16_t> p) {
  const std::uint16_t macro = write ? kWriteMacro : kReadMacro;
  if (!options_.enabled) return macroTrap(m, macro, errorWord(0, JobError::NotEnabled));
  const auto signal = readSignal(m, p[0]);
  if (!signal) return Trap{sinumerik::Alarm::Substitution, {0, p[0], 0}};
  const Request asked = readRequest(m, write, p);
  if (!*signal) {
    if (asked.interfaceByte) release(m, *asked.interfaceByte);
    return std::nullopt;
  }
  if (const Error error = request(m, asked)) return macroTrap(m, macro, *error);
  return std::nullopt;
}

// The same call in the next cycle, the signal still 1, is the same request; after a cycle without a
// call it is a new one (conditional call).
Error DataExchange::request(Machine& m, const Request& asked) {
  if (!asked.interfaceByte) return errorWord(0, JobError::InterfaceByte);
  const unsigned number = *asked.interfaceByte;
  const InterfaceByte byte(m, number);
  if (!byte.exists()) return errorWord(number, JobError::Place);
  Caller& caller = callers_[number];
  const bool stays = caller.last == asked && caller.cycle + 1 >= cycle_;
  caller.last = asked;
  caller.cycle = cycle_;
  if (byte.bit(options_.bits.busy) || (stays && !caller.waits)) return std::nullopt;
  return take(m, asked, caller);
}

Error DataExchange::take(Machine& m, const Request& asked, Caller& caller) {
  const auto [job, error] = makeJob(asked, m, options_.model);
  if (error) return errorWord(*asked.interfaceByte, *error);
  const HandshakeBits& bits = options_.bits;
  InterfaceByte byte(m, job.interfaceByte);
  byte.set(bits.requested, true);
  byte.set(bits.done, false);
  byte.set(bits.error, false);
  caller.waits = full() && job.interfaceByte != kAlarmByte;
  byte.set(bits.full, caller.waits);
  byte.set(bits.busy, !caller.waits);
  if (!caller.waits) enqueue(job, m.clock);
  return std::nullopt;
}

// The job of byte 65 goes before all that wait.
void DataExchange::enqueue(const Job& job, Instant now) {
  const Waiting waiting{job, {(now.ns / options_.clock.ns + 1) * options_.clock.ns}};
  if (job.interfaceByte == kAlarmByte)
    jobs_.push_front(waiting);
  else
    jobs_.push_back(waiting);
}

// The signal has gone: the answer goes, too, but not the job.
void DataExchange::release(Machine& m, unsigned number) {
  callers_[number] = {};
  const HandshakeBits& bits = options_.bits;
  InterfaceByte byte(m, number);
  if (byte.bit(bits.busy)) return;
  for (const auto bit : {bits.requested, bits.full, bits.done, bits.error}) byte.set(bit, false);
}

void DataExchange::restart(Machine& m) {
  clear();
  cycle_ = 0;
  const HandshakeBits& bits = options_.bits;
  for (unsigned number = 1; number <= kInterfaceBytes; ++number)
    for (const auto bit :
         {bits.requested, bits.full, bits.running, bits.busy, bits.done, bits.error})
      InterfaceByte(m, number).set(bit, false);
}

void DataExchange::clear() {
  jobs_.clear();
  running_.reset();
  callers_ = {};
}

Instant DataExchange::next() const {
  if (running_) return end_;
  return jobs_.empty() ? Instant::never() : jobs_.front().earliest;
}

std::optional<Trap> DataExchange::advance(Machine& m, Control& control, Instant now) {
  while (next() <= now) {
    if (!running_) {
      end_ = jobs_.front().earliest + options_.clock;
      begin(m);
      continue;
    }
    if (const auto trap = finish(m, control)) return trap;
    for (Waiting& waiting : jobs_) waiting.earliest = std::max(waiting.earliest, end_);
  }
  return std::nullopt;
}

void DataExchange::delay(Duration by) {
  end_ = end_ + by;
  for (Waiting& waiting : jobs_) waiting.earliest = waiting.earliest + by;
}

void DataExchange::begin(Machine& m) {
  running_ = jobs_.front().job;
  jobs_.pop_front();
  InterfaceByte(m, running_->interfaceByte).set(options_.bits.running, true);
}

std::optional<Trap> DataExchange::finish(Machine& m, Control& control) {
  const Job job = *running_;
  running_.reset();
  const Result result = execute(job, control, m);
  if (result == Result::Refused && job.write) control.raise(kWrongValue);
  const HandshakeBits& bits = options_.bits;
  InterfaceByte byte(m, job.interfaceByte);
  for (const auto bit : {bits.requested, bits.running, bits.busy}) byte.set(bit, false);
  byte.set(bits.done, true);
  byte.set(bits.error, result != Result::Done);
  if (result == Result::Done || result == Result::Refused) return std::nullopt;
  const JobError error = result == Result::NoPlace ? JobError::Place : JobError::Format;
  return macroTrap(m, job.macro(), errorWord(job.interfaceByte, error));
}

}  // namespace merker::nc
