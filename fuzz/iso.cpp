// Bytes of a TCP connection, cut at any place: whatever comes, both cuts mean the same, no message
// is longer than what came, and after the end nothing comes.
#include "harness.h"
#include "iso/transport.h"

using namespace merker;
using iso::Event;

namespace {

struct Seen {
  std::vector<iso::Bytes> messages;
  std::vector<Event::Kind> kinds;
};

void drain(iso::Transport& transport, Seen& seen) {
  while (auto event = transport.next()) {
    seen.kinds.push_back(event->kind);
    if (event->kind == Event::Kind::Requested)
      fuzz::require(!transport.confirm().empty(), "a request is confirmed");
    if (event->kind == Event::Kind::Message) seen.messages.push_back(std::move(event->message));
  }
}

Seen take(iso::View bytes, std::size_t portion, iso::Transport::Side side) {
  iso::Transport transport(side);
  if (side == iso::Transport::Side::Calling) transport.request({});
  Seen seen;
  while (!bytes.empty()) {
    const std::size_t count = std::min(portion, bytes.size());
    transport.feed(bytes.first(count));
    drain(transport, seen);
    bytes = bytes.subspan(count);
  }
  return seen;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const iso::View bytes(data + 1, size - 1);
  const auto side =
      (data[0] & 0x80) != 0 ? iso::Transport::Side::Calling : iso::Transport::Side::Called;
  const Seen whole = take(bytes, bytes.size(), side);
  const Seen parts = take(bytes, 1u + (data[0] & 0x7F), side);
  fuzz::require(whole.kinds == parts.kinds && whole.messages == parts.messages,
                "it does not matter where TCP cuts");
  std::size_t octets = 0;
  for (const iso::Bytes& message : whole.messages) octets += message.size();
  fuzz::require(octets <= bytes.size(), "messages are made of what came");
  return 0;
}
