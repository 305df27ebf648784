#include "system/subnet_links.h"

#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "system/connections.h"

namespace merker::system {
namespace {

constexpr std::size_t kLinkHead = 3;  // message, number of the connection
// A telegram of PROFIBUS and MPI has 246 octets of data at most.
constexpr std::uint16_t kLongestMpiPdu = 240;

template <typename Message>
bool isOf(const std::vector<std::uint8_t>& data) {
  return data.size() >= kLinkHead && data[0] >= static_cast<std::uint8_t>(Message::Connect) &&
         data[0] <= static_cast<std::uint8_t>(Message::End);
}

bool isOfLink(const std::vector<std::uint8_t>& data) { return isOf<LinkMessage>(data); }

}  // namespace

void SubnetLinks::add(const network::ConnectionEnd& end, std::uint16_t pdu, Connections& program,
                      const BasicCommunication& mpi) {
  const bool overMpi = mpi.reads(*end.node);
  auto link =
      std::make_unique<SubnetLink>(end, server_, overMpi ? std::min(pdu, kLongestMpiPdu) : pdu);
  if (end.id) link->place = program.add(*end.id);
  links_.push_back(std::move(link));
  if (!overMpi) read(*end.node);
}

void SubnetLinks::add(const network::ConnectionEnd& end, SendReceive& cp) {
  const std::size_t place = cp.add(static_cast<std::uint8_t>(end.id.value_or(0)), end.kind);
  cpLinks_.push_back(std::make_unique<SendReceiveLink>(end, place));
  read(*end.node);
}

void SubnetLinks::read(network::Node& node) {
  if (std::ranges::count(nodes_, &node) == 0) nodes_.push_back(&node);
}

// Without data: it could not be delivered, to whatever connection it belonged.
void SubnetLinks::hear(const network::Node& node, const network::Telegram& telegram, Instant now) {
  const bool returned = telegram.data.empty();
  if (!returned && !isOfLink(telegram.data)) return;
  for (const auto& link : links_) {
    if (link->end().node != &node || link->end().partner != telegram.from) continue;
    if (returned)
      link->lost(now);
    else if (loadWord(&telegram.data[1]) == link->end().number)
      link->hear(static_cast<LinkMessage>(telegram.data[0]),
                 s7comm::View(telegram.data).subspan(kLinkHead), now);
  }
}

void SubnetLinks::hearCp(const network::Node& node, const network::Telegram& telegram,
                         SendReceive& cp, Instant now) {
  if (!isOf<CpMessage>(telegram.data)) return;
  for (const auto& link : cpLinks_)
    if (link->end().node == &node && link->end().partner == telegram.from &&
        loadWord(&telegram.data[1]) == link->end().number)
      link->hear(static_cast<CpMessage>(telegram.data[0]),
                 SendReceiveLink::View(telegram.data).subspan(kLinkHead), cp, now);
}

void SubnetLinks::receive(BasicCommunication& mpi, SendReceive& cp, Instant now) {
  for (const network::Telegram& telegram : mpi.others())
    if (mpi.node() != nullptr) hear(*mpi.node(), telegram, now);
  std::erase_if(mpi.others(), [](const network::Telegram& one) {
    return one.data.empty() || isOfLink(one.data);
  });
  for (network::Node* const node : nodes_)
    while (const auto telegram = node->receive(now)) {
      hear(*node, *telegram, now);
      hearCp(*node, *telegram, cp, now);
    }
}

void SubnetLinks::wake(Instant now) {
  if (!std::exchange(asleep_, false)) return;
  for (const auto& link : links_) link->rise(now);
  for (const auto& link : cpLinks_) link->rise(now);
}

void SubnetLinks::sleep(SendReceive& cp) {
  if (std::exchange(asleep_, true)) return;
  for (const auto& link : links_) link->fall();
  for (const auto& link : cpLinks_) link->fall(cp);
}

void SubnetLinks::serve(BasicCommunication& mpi, Connections& program, SendReceive& cp,
                        Instant now) {
  wake(now);
  receive(mpi, cp, now);
  for (const auto& link : links_) {
    link->move(now);
    link->exchange(program, now);
  }
  for (const auto& link : cpLinks_) {
    link->move(cp, now);
    link->exchange(cp, now);
  }
}

void SubnetLinks::rest(BasicCommunication& mpi, SendReceive& cp, Instant now, bool powered) {
  if (!powered) {
    sleep(cp);
    mpi.others().clear();
    for (network::Node* const node : nodes_)
      while (node->receive(now)) continue;
    return;
  }
  wake(now);
  receive(mpi, cp, now);
  for (const auto& link : links_) link->move(now);
  for (const auto& link : cpLinks_) link->move(cp, now);
}

Instant SubnetLinks::next() const {
  Instant first = Instant::never();
  for (const network::Node* const node : nodes_) first = std::min(first, node->next());
  if (asleep_) return first;
  for (const auto& link : links_) first = std::min(first, link->next());
  for (const auto& link : cpLinks_) first = std::min(first, link->next());
  return first;
}

}  // namespace merker::system
