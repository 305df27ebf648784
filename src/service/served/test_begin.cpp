// What begins a job, or answers at once.
#include <algorithm>
#include <span>

#include "served/block_task.h"
#include "served/breakpoint_task.h"
#include "served/flash_task.h"
#include "served/force_job.h"
#include "served/test_call.h"
#include "served/test_stacks.h"
#include "station/block_cpu.h"

namespace merker::served {

using s7comm::BlockWatch;
using s7comm::Error;
using s7comm::TestAnswer;
using s7comm::TestFunction;
using s7comm::TriggerEvent;

namespace {

// Of one connection; a variable table of 30 rows is two.
constexpr std::size_t kMostJobs = 8;

Error checkTrigger(const TestCall& call, std::span<const TriggerEvent> offered) {
  const auto event = static_cast<TriggerEvent>(call.request.job.event);
  return std::ranges::find(offered, event) == offered.end() ? Error::WrongTrigger : Error::None;
}

// An indication is one PDU.
Error checkRoom(const TestCall& call, std::size_t octets) {
  const bool fits = s7comm::testOctets({}).size() + octets <= call.client->room();
  return fits ? Error::None : Error::ResultTooLong;
}

bool hasAllJobs(const TestCall& call) {
  return call.tasks().count<TestTask>(*call.client) >= kMostJobs;
}

TestAnswer begin(const TestCall& call, const std::shared_ptr<TestTask>& task) {
  if (hasAllJobs(call)) return {Error::TooManyJobs};
  call.tasks().begin(task);
  return {};
}

std::size_t octetsOf(const BlockWatch& watch) {
  std::size_t octets = 2 + s7comm::registerOctets(watch.registers);
  for (const BlockWatch::Line& line : watch.lines)
    octets += 2 + s7comm::registerOctets(line.registers);
  return octets;
}

// With a source: a statement. A block that was downloaded has none, but instructions all the same.
bool canHoldAt(const monitor::BlockCode& code, std::uint32_t offset) {
  return offset < code.length() && code.instructionAt(offset) == offset &&
         monitor::beginsStatement(code, offset);
}

// Of what a breakpoint tells.
constexpr std::size_t kBreakpointOctets = 38;

Error checkBlock(const TestCall& call) {
  constexpr TriggerEvent kOffered[] = {TriggerEvent::Addresses, TriggerEvent::CalledAddresses};
  if (const Error error = checkTrigger(call, kOffered); error != Error::None) return error;
  const BlockWatch& watch = call.request.job.block;
  const auto code = call.monitor.program().find(watchedBlock(watch));
  if (!code || code->length() == 0) return Error::NoBlockToTest;
  return checkRoom(call, octetsOf(watch));
}

// Nothing is interrupted while the CPU runs.
TestAnswer withStacks(const TestCall& call,
                      s7comm::Bytes (*data)(const TestCall& call, const monitor::Stacks&)) {
  const controller::Mode mode = call.monitor.plc().mode();
  if (mode != controller::Mode::Stop && mode != controller::Mode::Halt)
    return {Error::NotInThisMode};
  return {Error::None, 0, data(call, call.monitor.stacks())};
}

}  // namespace

Error checkVariables(const TestCall& call) {
  constexpr TriggerEvent kOffered[] = {TriggerEvent::Now, TriggerEvent::System,
                                       TriggerEvent::CycleBegin, TriggerEvent::CycleEnd,
                                       TriggerEvent::Stop};
  if (const Error error = checkTrigger(call, kOffered); error != Error::None) return error;
  std::size_t octets = 2;
  for (const s7comm::TestItem& item : call.request.job.items)
    octets += 4 + item.range.octets + item.range.octets % 2;
  return checkRoom(call, octets);
}

TestAnswer beginVariables(const TestCall& call) {
  if (const Error error = checkVariables(call); error != Error::None) return {error};
  const auto task = std::make_shared<VariableTask>(call.client, call.numbered(), call.monitor);
  call.monitor.watch(task);
  return begin(call, task);
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

TestAnswer beginBlock(const TestCall& call) {
  if (const Error error = checkBlock(call); error != Error::None) return {error};
  const auto task = std::make_shared<BlockTask>(call.client, call.numbered(), call.monitor);
  const TestAnswer answer = begin(call, task);
  if (answer.error == Error::None) call.monitor.debugger().watch(task);
  return answer;
}

TestAnswer beginBreakpoint(const TestCall& call) {
  if (!call.monitor.can(monitor::Feature::Breakpoints)) return {Error::TestNotOffered};
  const BlockWatch& watch = call.request.job.block;
  const auto code = call.monitor.program().find(watchedBlock(watch));
  if (!code || code->length() == 0) return {Error::NoBlockToTest};
  if (!canHoldAt(*code, watch.begin)) return {Error::WrongTestAddress};
  if (const Error error = checkRoom(call, kBreakpointOctets); error != Error::None) return {error};
  if (hasAllJobs(call)) return {Error::TooManyJobs};
  return begin(call, std::make_shared<BreakpointTask>(call.client, call.numbered(), call.monitor));
}

// Its first octet of data: 0 to the next breakpoint, 1 to the next statement.
TestAnswer exitHold(const TestCall& call) {
  const s7comm::Bytes& until = call.request.job.data;
  if (until.empty()) return {Error::WrongJobLength};
  if (until[0] > 1) return {Error::WrongTestData};
  if (call.monitor.plc().mode() != controller::Mode::Halt) return {Error::NotInThisMode};
  for (const auto& task : call.tasks().all())
    if (auto* const one = dynamic_cast<BreakpointTask*>(task.get())) one->goOn();
  const Instant now = call.monitor.plc().now();
  monitor::Debugger& debugger = call.monitor.debugger();
  until[0] == 0 ? debugger.run(now) : debugger.beginStep(monitor::StepKind::Into, now);
  return {};
}

TestAnswer beginFlash(const TestCall& call) {
  if (controller::capability<station::BlockCpu>(call.monitor.plc()) == nullptr)
    return {Error::TestNotOffered};
  return begin(call, std::make_shared<FlashTask>(call.client, call.numbered(), call.monitor));
}

TestAnswer interruptStack(const TestCall& call) {
  return withStacks(call, [](const TestCall&, const monitor::Stacks& stacks) {
    return interruptStackData(stacks);
  });
}

TestAnswer blockStack(const TestCall& call) {
  return withStacks(
      call, [](const TestCall&, const monitor::Stacks& stacks) { return blockStackData(stacks); });
}

// Priority class, and how many blocks above its OB.
TestAnswer localStack(const TestCall& call) {
  return withStacks(call, [](const TestCall& from, const monitor::Stacks& stacks) {
    const s7comm::Bytes& which = from.request.job.data;
    return which.size() < 2 ? s7comm::Bytes() : localStackData(stacks, which[0], which[1]);
  });
}

}  // namespace merker::served
