#include "served/bench.h"

#include <algorithm>
#include <iterator>

#include "served/force_job.h"
#include "served/system.h"
#include "served/test_call.h"
#include "served/test_task.h"

namespace merker::served {

using s7comm::Error;
using s7comm::TestAnswer;
using s7comm::TestFunction;
using s7comm::TestJob;
using s7comm::TestName;

namespace {

bool isForce(TestName name) {
  return name.function == static_cast<std::uint8_t>(TestFunction::Force);
}

// The job that is meant, of whomever; null: there is none. Recorded requests name numbers that
// another CPU gave: they mean the connection's last job of that function.
TestTask* taskOf(const TestCall& call, TestName name) {
  TestTask* last = nullptr;
  for (const auto& task : call.tasks().all()) {
    auto* const one = dynamic_cast<TestTask*>(task.get());
    if (one == nullptr || one->job().name.function != name.function) continue;
    if (one->job().name == name) return one;
    if (&one->client() == call.client.get()) last = one;
  }
  return last;
}

// Does it with the job that the request names.
TestAnswer withTask(const TestCall& call, Error (*act)(const TestCall&, TestTask&)) {
  TestTask* const task = taskOf(call, call.request.other);
  if (task == nullptr) return {Error::NoSuchJob};
  if (&task->client() != call.client.get()) return {Error::JobOfAnother};
  return {act(call, *task)};
}

bool isForceJob(const TestCall& call) {
  return isForce(call.request.other) && !call.monitor.forces().empty();
}

TestAnswer enable(const TestCall& call) {
  if (isForceJob(call)) return {Error::NotToBeEnabled};
  return withTask(call,
                  [](const TestCall&, TestTask& task) { return task.enable(true), Error::None; });
}

TestAnswer disable(const TestCall& call) {
  if (isForceJob(call)) return {Error::NotToBeEnabled};
  return withTask(call,
                  [](const TestCall&, TestTask& task) { return task.enable(false), Error::None; });
}

TestAnswer removeJob(const TestCall& call) {
  if (isForceJob(call)) return call.monitor.unforceAll(), TestAnswer{};
  return withTask(call, [](const TestCall& from, TestTask& task) {
    from.tasks().remove(task, from.monitor);
    return Error::None;
  });
}

TestAnswer replaceJob(const TestCall& call) {
  if (isForceJob(call)) return {forceInstead(call.monitor, call.request.job.items)};
  return withTask(call, [](const TestCall& from, TestTask& task) {
    if (!task.isReplaceable()) return Error::NotToBeReplaced;
    const Error error = checkVariables(from);
    if (error == Error::None) task.replace(from.request.job);
    return error;
  });
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
    {TestFunction::BlockStatus, 3, beginBlock},
    {TestFunction::ProgramStatus, 3, beginBlock},
    {TestFunction::InterruptStack, 3, interruptStack},
    {TestFunction::BlockStack, 3, blockStack},
    {TestFunction::LocalStack, 3, localStack},
    {TestFunction::Force, 2, beginForce},
    {TestFunction::Breakpoint, 2, beginBreakpoint},
    {TestFunction::ExitHold, 2, exitHold},
    {TestFunction::Disable, 3, disable},
    {TestFunction::Enable, 3, enable},
    {TestFunction::Delete, 2, removeJob},
    {TestFunction::List, 3, listJobs},
    {TestFunction::Read, 3, readJob},
    {TestFunction::Replace, 2, replaceJob},
    {TestFunction::FlashLed, 3, beginFlash},
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

std::size_t Bench::jobs(const monitor::Monitor& monitor) const {
  const auto tests = std::ranges::count_if(tasks_.all(), [](const auto& task) {
    return dynamic_cast<const TestTask*>(task.get()) != nullptr;
  });
  return static_cast<std::size_t>(tests) + (monitor.forces().empty() ? 0 : 1);
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
