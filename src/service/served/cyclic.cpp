#include "served/cyclic.h"

#include <utility>

#include "served/values.h"

namespace merker::served {
namespace {

using s7comm::Error;
using s7comm::Outlet;

CyclicTask* cyclicJob(const Tasks& tasks, const Outlet& client, std::uint8_t number) {
  return tasks.find<CyclicTask>(client,
                                [&](const CyclicTask& task) { return task.number() == number; });
}

// Recorded requests name numbers that another CPU gave: they mean the connection's last job.
CyclicTask* namedJob(const Tasks& tasks, const Outlet& client, std::uint8_t number) {
  if (CyclicTask* const job = cyclicJob(tasks, client, number)) return job;
  CyclicTask* last = nullptr;
  tasks.find<CyclicTask>(client, [&](CyclicTask& task) { return last = &task, false; });
  return last;
}

}  // namespace

std::vector<s7comm::Value> CyclicTask::set(s7comm::CyclicRead read,
                                           const controller::Controller& plc) {
  read_ = std::move(read);
  next_ = plc.now() + Duration::milliseconds(read_.milliseconds);
  last_ = valuesNow(plc, read_.ranges);
  return last_;
}

// Intervals that a cycle is longer than are left out. What the client has no room for is lost, and
// the next change is one against what it has got.
bool CyclicTask::run(monitor::Monitor& monitor) {
  const controller::Controller& plc = std::as_const(monitor).plc();
  const Duration interval = Duration::milliseconds(read_.milliseconds);
  if (plc.now() + interval < next_) next_ = plc.now();  // a snapshot has turned time back
  if (plc.now() < next_) return true;
  while (next_ <= plc.now()) next_ = next_ + interval;
  auto values = valuesNow(plc, read_.ranges);
  if (read_.onChange && values == last_) return true;
  const bool sent = client().send({.group = 2,
                                   .subfunction = read_.subfunction,
                                   .sequence = number_,
                                   .octets = read_.data(values)});
  if (sent) last_ = std::move(values);
  return true;
}

Subscribed subscribe(Tasks& tasks, const controller::Controller& plc,
                     const std::shared_ptr<Outlet>& client, std::optional<std::uint8_t> number,
                     const s7comm::CyclicRead& read) {
  if (number) {
    CyclicTask* const job = namedJob(tasks, *client, *number);
    if (job == nullptr || !job->onChange()) return {Error::NoSuchReading};
    return {Error::None, job->number(), job->set(read, plc)};
  }
  if (tasks.count<CyclicTask>(*client) >= CyclicTask::kMost) return {Error::TooManyReadings};
  std::uint8_t free = 1;
  while (cyclicJob(tasks, *client, free) != nullptr) ++free;
  const auto task = std::make_shared<CyclicTask>(client, free);
  auto values = task->set(read, plc);
  tasks.begin(task);
  return {Error::None, free, std::move(values)};
}

Error unsubscribe(Tasks& tasks, monitor::Monitor& monitor, const Outlet& client,
                  std::uint8_t number) {
  const CyclicTask* const job = namedJob(tasks, client, number);
  if (job == nullptr) return Error::NoSuchReading;
  tasks.remove(*job, monitor);
  return Error::None;
}

}  // namespace merker::served
