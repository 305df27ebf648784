#include "served/bench.h"

#include <algorithm>
#include <iterator>

#include "served/force_job.h"
#include "served/system.h"
#include "served/test_task.h"

namespace merker::served {

using s7comm::Error;
using s7comm::TestAnswer;
using s7comm::TestFunction;
using s7comm::TestJob;
using s7comm::TestName;

// A request that is carried out.
struct TestCall {
  Bench& bench;
  monitor::Monitor& monitor;
  const s7comm::TestRequest& request;
  const Bench::Client& client;
  std::uint8_t number = 0;

  Tasks& tasks() const { return bench.tasks_; }
  TestJob numbered() const {
    TestJob job = request.job;
    job.name.number = number;
    return job;
  }
  std::uint8_t forceNumber() const { return bench.forceNumber(monitor); }
  void forced() const { bench.force_ = number; }
};

namespace {

// Of one connection; a variable table of 30 rows is two.
constexpr std::size_t kMostJobs = 8;

bool isForce(TestName name) {
  return name.function == static_cast<std::uint8_t>(TestFunction::Force);
}

// The job that is meant, of whomever; null: there is none.
TestTask* taskOf(const TestCall& call, TestName name) {
  for (const auto& task : call.tasks().all())
    if (auto* const one = dynamic_cast<TestTask*>(task.get());
        one != nullptr && one->job().name == name)
      return one;
  return nullptr;
}

// Does it with the job that the request names.
TestAnswer withTask(const TestCall& call, void (*act)(const TestCall&, TestTask&)) {
  TestTask* const task = taskOf(call, call.request.other);
  if (task == nullptr) return {Error::NoSuchJob};
  if (&task->client() != call.client.get()) return {Error::JobOfAnother};
  act(call, *task);
  return {};
}

bool isForceJob(const TestCall& call) {
  return isForce(call.request.other) && call.request.other.number == call.forceNumber() &&
         !call.monitor.forces().empty();
}

// As long as what an indication says of them.
Error checkRoom(const TestCall& call) {
  std::size_t octets = s7comm::testOctets({}).size() + 2;
  for (const s7comm::TestItem& item : call.request.job.items)
    octets += 4 + item.range.octets + item.range.octets % 2;
  return octets <= call.client->room() ? Error::None : Error::ResultTooLong;
}

Error checkTrigger(const TestJob& job) {
  using enum s7comm::TriggerEvent;
  constexpr s7comm::TriggerEvent kOffered[] = {Now, CycleBegin, CycleEnd, Stop};
  const auto event = static_cast<s7comm::TriggerEvent>(job.event);
  return std::ranges::find(kOffered, event) == std::end(kOffered) ? Error::WrongTrigger
                                                                  : Error::None;
}

TestAnswer beginVariables(const TestCall& call) {
  if (const Error error = checkTrigger(call.request.job); error != Error::None) return {error};
  if (const Error error = checkRoom(call); error != Error::None) return {error};
  if (call.tasks().count<TestTask>(*call.client) >= kMostJobs) return {Error::TooManyJobs};
  const auto task = std::make_shared<VariableTask>(call.client, call.numbered(), call.monitor);
  call.monitor.watch(task);
  call.tasks().begin(task);
  return {};
}

TestAnswer beginForce(const TestCall& call) {
  if (!call.monitor.forces().empty()) return {Error::ForcedAlready};
  const Error error = forceAll(call.monitor, call.request.job.items);
  if (error != Error::None) return {error};
  call.forced();
  const std::vector codes(call.request.job.items.size(), s7comm::ItemCode::Done);
  call.client->send({.group = 1,
                     .subfunction = static_cast<std::uint8_t>(TestFunction::Force),
                     .sequence = call.number,
                     .octets = s7comm::testOctets(s7comm::modifiedData(codes))});
  return {};
}

TestAnswer enable(const TestCall& call) {
  if (isForceJob(call)) return {Error::NotToBeEnabled};
  return withTask(call, [](const TestCall&, TestTask& task) { task.enable(true); });
}

TestAnswer disable(const TestCall& call) {
  if (isForceJob(call)) return {Error::NotToBeEnabled};
  return withTask(call, [](const TestCall&, TestTask& task) { task.enable(false); });
}

TestAnswer removeJob(const TestCall& call) {
  if (isForceJob(call)) return call.monitor.unforceAll(), TestAnswer{};
  return withTask(
      call, [](const TestCall& from, TestTask& task) { from.tasks().remove(task, from.monitor); });
}

TestAnswer replaceJob(const TestCall& call) {
  if (isForceJob(call)) return {forceInstead(call.monitor, call.request.job.items)};
  if (const Error error = checkRoom(call); error != Error::None) return {error};
  return withTask(call,
                  [](const TestCall& from, TestTask& task) { task.replace(from.request.job); });
}

// Function, number, 1 while it is enabled, 0.
TestAnswer listJobs(const TestCall& call) {
  s7comm::Bytes data;
  const auto add = [&data](TestName name, bool enabled) {
    data.insert(data.end(),
                {name.function, name.number, static_cast<std::uint8_t>(enabled ? 1 : 0), 0});
  };
  if (!call.monitor.forces().empty())
    add({static_cast<std::uint8_t>(TestFunction::Force), call.forceNumber()}, true);
  for (const auto& task : call.tasks().all())
    if (const auto* const one = dynamic_cast<const TestTask*>(task.get()))
      add(one->job().name, one->enabled());
  data.resize(std::min(data.size(), call.client->room() - s7comm::testOctets({}).size()) / 4 * 4);
  return {Error::None, 0, data};
}

TestAnswer readJob(const TestCall& call) {
  s7comm::Bytes data;
  if (isForceJob(call)) {
    data = s7comm::jobData(forceJobOf(call.monitor, call.forceNumber()));
  } else {
    const TestTask* const task = taskOf(call, call.request.other);
    if (task == nullptr) return {Error::NoSuchJob};
    data = s7comm::jobData(task->job());
  }
  const bool fits = s7comm::testOctets(data).size() <= call.client->room();
  return fits ? TestAnswer{Error::None, 0, data} : TestAnswer{Error::ResultTooLong};
}

struct TestService {
  TestFunction function;
  int level;  // of protection that asks for the password
  TestAnswer (*serve)(const TestCall& call);
};

constexpr TestService kTestServices[] = {
    {TestFunction::VariableStatus, 3, beginVariables},
    {TestFunction::Modify, 2, beginVariables},
    {TestFunction::Force, 2, beginForce},
    {TestFunction::Disable, 3, disable},
    {TestFunction::Enable, 3, enable},
    {TestFunction::Delete, 2, removeJob},
    {TestFunction::List, 3, listJobs},
    {TestFunction::Read, 3, readJob},
    {TestFunction::Replace, 2, replaceJob},
};

}  // namespace

// 1 to 255, and none that a job has.
std::uint8_t Bench::freshNumber(const monitor::Monitor& monitor) {
  const auto used = [&](std::uint8_t number) {
    if (number == force_ && !monitor.forces().empty()) return true;
    return std::ranges::any_of(tasks_.all(), [&](const auto& task) {
      const auto* const one = dynamic_cast<const TestTask*>(task.get());
      return one != nullptr && one->job().name.number == number;
    });
  };
  do last_ = static_cast<std::uint8_t>(last_ % 0xFF + 1);
  while (used(last_));
  return last_;
}

// Others may have forced it: whoever sees it gives it a number.
std::uint8_t Bench::forceNumber(const monitor::Monitor& monitor) {
  if (monitor.forces().empty()) return force_ = 0;
  if (force_ == 0) force_ = freshNumber(monitor);
  return force_;
}

TestAnswer Bench::carryOut(monitor::Monitor& monitor, const s7comm::TestRequest& request,
                           const Client& client) {
  const auto* const service =
      std::ranges::find(kTestServices, request.function, &TestService::function);
  const TestCall call{*this, monitor, request, client, freshNumber(monitor)};
  TestAnswer answer{Error::TestNotOffered, 0, {}};
  if (service != std::end(kTestServices)) {
    const bool refused = isProtected(monitor.plc(), request.password, service->level);
    answer = refused ? TestAnswer{Error::TestProtected, 0, {}} : service->serve(call);
  }
  answer.number = call.number;
  return answer;
}

}  // namespace merker::served
