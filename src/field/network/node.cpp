#include "network/node.h"

namespace merker::network {

std::optional<Telegram> Node::receive(Instant now) {
  if (next() > now) return std::nullopt;
  Telegram telegram = std::move(in_.front());
  in_.pop_front();
  return telegram;
}

std::vector<Telegram> Node::takeSent(Instant end) {
  std::vector<Telegram> taken;
  for (; !out_.empty() && out_.front().at < end; out_.pop_front())
    taken.push_back(std::move(out_.front()));
  return taken;
}

}  // namespace merker::network
