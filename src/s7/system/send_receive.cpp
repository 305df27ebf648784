#include "system/send_receive.h"

#include <algorithm>
#include <utility>

namespace merker::system {

void SendReceive::configure(const std::vector<CpConnectionParameters>& connections) {
  connections_.clear();
  for (const CpConnectionParameters& one : connections) add(one.id, one.kind);
}

std::size_t SendReceive::add(std::uint8_t id, ConnectionKind kind) {
  connections_.push_back({.id = id, .kind = kind});
  return connections_.size() - 1;
}

void SendReceive::restart() {
  for (Connection& one : connections_) one = {.id = one.id, .kind = one.kind, .up = one.up};
}

SendReceive::Connection* SendReceive::find(std::uint32_t id) {
  const auto found = std::ranges::find(connections_, id, &Connection::id);
  return found == connections_.end() ? nullptr : &*found;
}

void SendReceive::begin(Connection& one, Bytes data) {
  one.sends = true;
  one.result.reset();
  one.out = std::move(data);
}

SendReceive::Bytes SendReceive::take(Connection& one, std::size_t octets) {
  Bytes taken;
  if (!one.isStream()) {
    taken = std::move(one.in.front());
    one.in.pop_front();
  }
  while (taken.size() < octets && one.isStream()) {
    Bytes& first = one.in.front();
    const auto part = static_cast<std::ptrdiff_t>(std::min(octets - taken.size(), first.size()));
    taken.insert(taken.end(), first.begin(), first.begin() + part);
    first.erase(first.begin(), first.begin() + part);
    if (first.empty()) one.in.pop_front();
  }
  one.waiting -= taken.size();
  return taken;
}

void SendReceive::connected(Connection& one, bool is) {
  one.up = is;
  if (is || !one.sends || one.result) return;
  one.out.reset();
  one.result = kNoConnection;
}

// The one that was carried: a restart may have come in between, and another job behind it.
void SendReceive::ended(Connection& one, std::uint16_t result) {
  if (one.sends && !one.out && !one.result) one.result = result;
}

bool SendReceive::arrived(Connection& one, Bytes data) {
  if (data.empty() || !one.hasRoom(data.size())) return false;
  one.waiting += data.size();
  one.in.push_back(std::move(data));
  return true;
}

}  // namespace merker::system
