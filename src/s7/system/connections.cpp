#include "system/connections.h"

#include <algorithm>
#include <utility>

namespace merker::system {
namespace {

template <typename Map>
typename Map::mapped_type* instanceOf(Map& map, Connections::Instance instance) {
  if (!map.contains(instance) && map.size() >= Connections::kMostInstances) return nullptr;
  return &map[instance];
}

}  // namespace

void Connections::configure(const std::vector<ConnectionParameters>& connections) {
  connections_.clear();
  for (const ConnectionParameters& one : connections) connections_.push_back({.id = one.id});
}

std::size_t Connections::add(std::uint16_t id) {
  connections_.push_back({.id = id});
  return connections_.size() - 1;
}

void Connections::restart() {
  senders_.clear();
  receivers_.clear();
  for (Connection& one : connections_) one.orders = {.restart = true};
}

std::optional<std::size_t> Connections::find(std::uint32_t id) const {
  const auto found = std::ranges::find(connections_, id, &Connection::id);
  if (found == connections_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - connections_.begin());
}

Connections::Sender* Connections::sender(Instance instance) {
  return instanceOf(senders_, instance);
}
Connections::Receiver* Connections::receiver(Instance instance) {
  return instanceOf(receivers_, instance);
}

void Connections::begin(Sender& sender, std::size_t connection, s7comm::PartnerJob job) {
  sender.job = job.number = ++jobs_;
  sender.connection = connection;
  sender.result.reset();
  connections_[connection].orders.jobs.push_back(std::move(job));
}

void Connections::abort(const Sender& sender) {
  connections_[sender.connection].orders.aborted.push_back(*sender.job);
}

Connections::Receiver* Connections::receiverOf(std::size_t connection, std::uint32_t rid,
                                               bool blocks) {
  const auto found = std::ranges::find_if(receivers_, [&](const auto& entry) {
    const Receiver& one = entry.second;
    return one.connection == connection && one.rid == rid && one.blocks == blocks;
  });
  return found == receivers_.end() ? nullptr : &found->second;
}

bool Connections::bind(Receiver& receiver, std::size_t connection, std::uint32_t rid, bool blocks) {
  if (receiverOf(connection, rid, blocks) != nullptr) return false;
  receiver.connection = connection;
  receiver.rid = rid;
  receiver.blocks = blocks;
  return true;
}

// The last state of each counts; there is a limit to those that nobody carries.
void Connections::tell(std::size_t connection, const s7comm::Receiver& state) {
  auto& list = connections_[connection].orders.receivers;
  std::erase_if(list, [&](const s7comm::Receiver& other) {
    return other.rid == state.rid && other.blocks == state.blocks;
  });
  if (list.size() < kMostInstances) list.push_back(state);
}

void Connections::release(Receiver& receiver) {
  tell(*receiver.connection, {.rid = receiver.rid, .removed = true, .blocks = receiver.blocks});
  receiver = {};
}

// One that has not been taken keeps others away.
void Connections::enable(Receiver& receiver, bool enabled, std::size_t room) {
  if (receiver.enabled == enabled && receiver.room == room) return;
  receiver.enabled = enabled;
  receiver.room = room;
  if (!enabled || receiver.telegrams.empty())
    tell(*receiver.connection,
         {.rid = receiver.rid, .enabled = enabled, .octets = room, .blocks = receiver.blocks});
}

s7comm::Telegram Connections::take(Receiver& receiver) {
  s7comm::Telegram telegram = std::move(receiver.telegrams.front());
  receiver.telegrams.pop_front();
  if (receiver.telegrams.empty())
    tell(*receiver.connection, {.rid = receiver.rid, .enabled = true, .octets = receiver.room});
  return telegram;
}

s7comm::ToPartner Connections::ordered(std::size_t connection) {
  return std::exchange(connections_[connection].orders, {});
}

void Connections::bring(std::size_t connection, s7comm::FromPartner news) {
  if (news.connected) connections_[connection].connected = *news.connected;
  for (s7comm::PartnerResult& result : news.results) {
    const auto found = std::ranges::find_if(
        senders_, [&](const auto& entry) { return entry.second.job == result.number; });
    if (found != senders_.end()) found->second.result = std::move(result);
  }
  for (auto& [instance, receiver] : receivers_)
    if (news.connected && receiver.connection == connection) receiver.begun = 0;
  for (const auto& [rid, octets] : news.begun)
    if (Receiver* const receiver = receiverOf(connection, rid, true)) receiver->begun = octets;
  for (s7comm::Telegram& telegram : news.telegrams) {
    Receiver* const receiver = receiverOf(connection, telegram.rid, true);
    if (receiver == nullptr) continue;
    receiver->begun = 0;
    receiver->telegrams.push_back(std::move(telegram));
  }
  if (!connections_[connection].orders.restart) bringNotices(connection, news);
}

// The newest one counts. What came in STOP, before the restart of which the link does not know yet,
// is forgotten as all data of these blocks.
void Connections::bringNotices(std::size_t connection, s7comm::FromPartner& news) {
  for (auto& [rid, notice] : news.notices) {
    Receiver* const receiver = receiverOf(connection, rid, false);
    if (receiver == nullptr || !receiver->enabled) continue;
    notice.overwrote |= receiver->notice.has_value();
    receiver->notice = std::move(notice);
  }
}

}  // namespace merker::system
