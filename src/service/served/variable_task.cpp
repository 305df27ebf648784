#include "served/test_task.h"
#include "served/values.h"

namespace merker::served {
namespace {

using monitor::CyclePoint;
using s7comm::ItemCode;
using s7comm::TestFunction;
using s7comm::TestJob;
using s7comm::TriggerEvent;

constexpr std::uint16_t kOnce = 1, kPermanently = 2;  // TestJob::often, TestJob::how

bool isModification(const TestJob& job) {
  return job.name.function == static_cast<std::uint8_t>(TestFunction::Modify);
}

std::optional<CyclePoint> pointOf(const TestJob& job) {
  switch (static_cast<TriggerEvent>(job.event)) {
    case TriggerEvent::CycleBegin:
      return CyclePoint::Begin;
    case TriggerEvent::CycleEnd:
      return CyclePoint::End;
    case TriggerEvent::Stop:
      return CyclePoint::Stop;
    default:
      return std::nullopt;
  }
}

// No cycle comes by; STEP 7 shows values all the same.
bool standsStill(const controller::Controller& plc) {
  return plc.mode() == controller::Mode::Stop || plc.mode() == controller::Mode::Halt;
}

}  // namespace

VariableTask::VariableTask(std::shared_ptr<s7comm::Outlet> client, TestJob job,
                           monitor::Monitor& monitor)
    : TestTask(std::move(client), std::move(job)), monitor_(monitor) {
  begin();
}

// A status that is to be looked at time and again waits until it is enabled.
void VariableTask::begin() {
  enable(job().how != 1 || isModification(job()));
  told_ = over_ = false;
}

void VariableTask::replace(TestJob job) {
  TestTask::replace(std::move(job));
  begin();
}

bool VariableTask::run(monitor::Monitor& monitor) {
  const auto point = pointOf(job());
  const bool now = !point || (*point != CyclePoint::Stop && standsStill(monitor.plc()));
  if (enabled() && now) act(false);
  return !over_;
}

void VariableTask::reached(CyclePoint point) {
  if (enabled() && !over_ && pointOf(job()) == point) act(point != CyclePoint::Stop);
}

void VariableTask::act(bool inCycle) {
  isModification(job()) ? modify(inCycle) : look();
  over_ = job().how == 0 || (job().often == kOnce && job().how != kPermanently);
}

void VariableTask::look() {
  std::vector<s7comm::Range> ranges;
  for (const s7comm::TestItem& item : job().items)
    if (item.code == ItemCode::Done) ranges.push_back(item.range);
  auto found = valuesNow(monitor_.plc(), ranges);
  std::vector<s7comm::Value> values;
  auto next = found.begin();
  for (const s7comm::TestItem& item : job().items)
    values.push_back(item.code == ItemCode::Done ? std::move(*next++)
                                                 : s7comm::Value{item.code, {}});
  enable(false);
  tell(s7comm::statusData(values));
}

void VariableTask::modify(bool inCycle) {
  std::vector<ItemCode> codes;
  for (const s7comm::TestItem& item : job().items) {
    const s7comm::Write write{item.range, item.value};
    codes.push_back(item.code != ItemCode::Done ? item.code
                    : inCycle                   ? putInCycle(monitor_, write)
                                                : put(monitor_, write));
  }
  if (!std::exchange(told_, true)) tell(s7comm::modifiedData(codes));
}

}  // namespace merker::served
