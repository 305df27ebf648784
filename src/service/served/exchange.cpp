#include "served/exchange.h"

#include <algorithm>
#include <utility>

#include "plc/capability.h"
#include "served/system.h"
#include "served/values.h"

namespace merker::served {
namespace {

using s7comm::ItemCode;
using s7comm::Range;
using s7comm::Value;
using s7comm::Write;

// A cycle or a startup that does not end for so long refuses what waits for its end.
constexpr Duration kLongestWait = Duration::seconds(5);

}  // namespace

void Exchange::connectBy(std::function<void(Call)> post, Call wake) {
  partners_.connectBy(post, wake);
  cpLines_.connectBy(post, wake);
  post_ = std::move(post);
  wake_ = std::move(wake);
}

void Exchange::opened() {
  ++connections_;
  wake_();
}

// The next one to connect gets no old values.
void Exchange::closed() {
  if (--connections_ > 0) return;
  const std::lock_guard lock(mutex_);
  image_.reset();
}

void Exchange::inUse(const Resources::Counts& connections) {
  const std::lock_guard lock(mutex_);
  inUse_ = connections;
  counted_ = true;
}

void Exchange::reachedBy(const std::optional<system::EthernetInterface>& ethernet) {
  const std::lock_guard lock(mutex_);
  ethernet_ = ethernet;
  counted_ = true;
}

void Exchange::tellConnections(controller::Controller& plc) {
  if (!counted_.exchange(false)) return;
  const std::lock_guard lock(mutex_);
  setConnections(plc, inUse_, ethernet_);
}

std::optional<std::vector<Value>> Exchange::copied(const std::vector<Range>& ranges) {
  std::unique_lock lock(mutex_);
  periphery_.ask(ranges);
  const std::shared_ptr<const Copy> copy = image_;
  lock.unlock();
  return copy ? valuesOf(*copy, ranges) : std::nullopt;
}

void Exchange::order(Order order) {
  {
    const std::lock_guard lock(mutex_);
    orders_.push_back(std::move(order));
    ordered_ = true;
  }
  wake_();
}

void Exchange::read(const std::vector<Range>& ranges, ReadDone done) {
  if (const auto values = copied(ranges)) return done(*values);
  order([ranges, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::vector<Value> values(ranges.size(), {ItemCode::HardwareFault, {}});
    if (monitor != nullptr) values = valuesNow(monitor->plc(), ranges);
    return [values = std::move(values), done] { done(values); };
  });
}

void Exchange::write(std::vector<Write> writes, WriteDone done) {
  order([writes = std::move(writes), done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::vector<ItemCode> codes(writes.size(), ItemCode::HardwareFault);
    for (std::size_t i = 0; monitor != nullptr && i < writes.size(); ++i)
      codes[i] = put(*monitor, writes[i]);
    return [codes = std::move(codes), done] { done(codes); };
  });
}

// Orders first: who is told that its value was written reads it then.
void Exchange::cycleEnded(monitor::Monitor& monitor) {
  tellConnections(monitor.plc());
  exchangeConfigured(monitor.plc());
  if (connections_ == 0) return tasks_.clear(monitor);
  carryOut(&monitor);
  tasks_.run(monitor, post_);
  publish(monitor.plc());
}

void Exchange::exchangeConfigured(controller::Controller& plc) {
  partners_.exchange(plc);
  cpLines_.exchange(plc);
}

void Exchange::carryOut(monitor::Monitor* monitor) {
  waitingSince_ = Instant::never();
  if (!ordered_.exchange(false)) return;
  std::deque<Order> orders;
  {
    const std::lock_guard lock(mutex_);
    orders.swap(orders_);
  }
  std::vector<Call> answers;
  answers.reserve(orders.size());
  for (const Order& order : orders) answers.push_back(order(monitor));
  if (monitor != nullptr) publish(monitor->plc());
  for (Call& answer : answers) post_(std::move(answer));
}

// A copy that nobody reads any more is the place of the next one.
void Exchange::publish(const controller::Controller& plc) {
  const auto* const memory = controller::capability<controller::OperandMemory>(plc);
  if (memory == nullptr) return;
  if (!spare_ || spare_.use_count() > 1) spare_ = std::make_shared<Copy>();
  std::atomic_thread_fence(std::memory_order_acquire);  // what its last reader did is over
  memory->copyOperands(spare_->operands);
  const std::lock_guard lock(mutex_);
  periphery_.copy(plc, *spare_);
  if (connections_ > 0) image_.swap(spare_);
}

// STOP, HALT, or time that somebody holds.
bool Exchange::stands(const controller::Controller& plc) {
  using controller::Mode;
  const Mode mode = plc.mode();
  const bool held = plc.now() == std::exchange(lastLook_, plc.now());
  return held || mode == Mode::Stop || mode == Mode::Halt;
}

void Exchange::look(monitor::Monitor* monitor) {
  reachable_ = monitor == nullptr || std::as_const(*monitor).plc().powered();
  if (!reachable_) monitor = nullptr;  // it answers no more than one that is not there
  if (monitor != nullptr) tellConnections(monitor->plc());
  if (connections_ == 0 && monitor != nullptr) {
    if (stands(std::as_const(*monitor).plc())) exchangeConfigured(monitor->plc());
    return tasks_.clear(*monitor);
  }
  if (connections_ == 0) return tasks_.forget();
  if (monitor == nullptr) {
    carryOut(nullptr);
    return forget();
  }
  const controller::Controller& plc = std::as_const(*monitor).plc();
  if (stands(plc)) return cycleEnded(*monitor);
  if (!ordered_) return;
  if (waitingSince_ == Instant::never()) waitingSince_ = plc.now();
  if (plc.now() - waitingSince_ > kLongestWait) carryOut(nullptr);
}

void Exchange::forget() {
  lastLook_ = waitingSince_ = Instant::never();
  partners_.forget();
  cpLines_.forget();
  tasks_.forget();
  passive_.clear();
  const std::lock_guard lock(mutex_);
  image_.reset();
  counted_ = true;  // what it has to know, too
}

}  // namespace merker::served
