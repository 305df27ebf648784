// The side that wants something: connections and jobs of this CPU.
#include "system/basic_communication.h"

#include <utility>

namespace merker::system {
namespace {

// A partner that does not answer for so long is not there any more (docs/compatibility.md).
constexpr Duration kPatience = Duration::seconds(2);

}  // namespace

void BasicCommunication::join(network::Node& node, std::size_t connections) {
  node_ = &node;
  connections_ = connections;
}

void BasicCommunication::send(std::uint8_t to, const BasicMessage& message, Instant now) {
  node_->send(now, to, encode(message));
}

std::uint32_t BasicCommunication::call(const Order& order, Instant now,
                                       std::vector<std::uint8_t>& answer) {
  receive(now);
  const auto found = links_.find(order.partner);
  if (found == links_.end() || !found->second.job)
    return order.begin ? begin(order, now) : basic::kIdle;
  Link& link = found->second;
  const bool same = link.job->kind == order.kind && link.job->id == order.id;
  if (!same) return order.begin ? basic::kBusy : basic::kIdle;
  if (link.answer) return finish(order.partner, answer, now);
  if (now < link.deadline) return basic::kRuns;
  const bool connected = link.connected;
  links_.erase(found);
  return connected ? basic::kBroken : basic::kUnreachable;
}

// The connection comes first, unless it was kept.
std::uint32_t BasicCommunication::begin(const Order& order, Instant now) {
  if (order.partner > kHighestAddress) return basic::kNoAddress;
  if (order.dataError != 0) return order.dataError;
  const auto found = links_.find(order.partner);
  if (found == links_.end() && full()) return basic::kNoResources;
  Link& link = links_[order.partner];
  link.keep = order.keep;
  link.job = BasicMessage{order.kind, ++lastJob_, 0, order.id, order.there, order.data};
  link.deadline = now + kPatience;
  link.aborting = false;
  if (node_ == nullptr || order.partner == node_->address())
    over(order.partner, basic::kUnreachable);
  else
    send(order.partner, link.connected ? *link.job : BasicMessage{MessageKind::Connect, lastJob_},
         now);
  return basic::kBegun;
}

std::uint32_t BasicCommunication::finish(std::uint8_t partner, std::vector<std::uint8_t>& answer,
                                         Instant now) {
  Link& link = links_.at(partner);
  const std::uint32_t code = link.answer->code;
  answer = std::move(link.answer->data);
  link.job.reset();
  link.answer.reset();
  if (link.connected && link.keep) return code;
  if (link.connected) send(partner, {MessageKind::End, lastJob_}, now);
  links_.erase(partner);
  return code;
}

// Ends a connection that CONT = 1 has kept, with the job that uses it. The partner learns of it by
// a telegram that it does not answer, so the second call is the last one.
std::uint32_t BasicCommunication::abort(std::uint8_t partner, bool begin, Instant now) {
  receive(now);
  const auto found = links_.find(partner);
  if (found != links_.end() && found->second.aborting) {
    links_.erase(found);
    return 0;
  }
  if (!begin) return basic::kIdle;
  if (partner > kHighestAddress) return basic::kNoAddress;
  Link& link = links_[partner];  // without a connection there is nothing to end
  if (link.connected) send(partner, {MessageKind::End, lastJob_}, now);
  link = Link{};
  link.aborting = true;
  return basic::kBegun;
}

void BasicCommunication::over(std::uint8_t partner, std::uint32_t code,
                              std::vector<std::uint8_t> data) {
  const auto found = links_.find(partner);
  if (found == links_.end() || !found->second.job || found->second.answer) return;
  found->second.answer = BasicMessage{
      MessageKind::Answer, 0, static_cast<std::uint16_t>(code), 0, {}, std::move(data)};
}

void BasicCommunication::restart() {
  links_.clear();
  queue_.clear();
  wishes_.clear();
  stopped_ = false;
}

}  // namespace merker::system
