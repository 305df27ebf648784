// CPUs whose programs call the communication blocks, for tests.
#pragma once

#include "links.h"
#include "serial/link_blocks.h"

namespace merker::serial {

class Blocks : public DataBlocks {
 public:
  std::optional<std::size_t> size(std::uint32_t block) const override {
    const auto found = bytes.find(block);
    return found == bytes.end() ? std::nullopt : std::optional(found->second.size());
  }
  Bytes read(const Place& from, std::size_t count) const override {
    const auto at = bytes.at(from.block).begin() + from.offset;
    return {at, at + static_cast<std::ptrdiff_t>(count)};
  }
  void write(const Place& to, std::span<const std::uint8_t> data) override {
    std::copy(data.begin(), data.end(), bytes.at(to.block).begin() + to.offset);
  }
  std::map<std::uint32_t, Bytes> bytes;
};

inline std::string shown(const Answer& answer) {
  if (answer == Answer{}) return "-";
  const std::string status = fmt::format("{:04X}", static_cast<unsigned>(answer.status));
  return (answer.done ? "DONE " : answer.error ? "ERROR " : "") + status;
}

// What calls have shown, one after the other.
inline std::string joined(std::initializer_list<std::string> shown) {
  std::string result;
  for (const std::string& one : shown) result += one;
  return result;
}

// A CPU with one call of each block; the start-up is over.
class Program {
 public:
  explicit Program(const Parameters& parameters = {})
      : interface(parameters),
        sender(interface),
        receiver(interface),
        clearer(interface),
        sendRk(interface, false),
        fetchRk(interface, true),
        server(interface) {
    for (std::uint32_t block : {10U, 20U}) blocks.bytes[block].resize(2000);
    memory.area('M').resize(256);
    for (unsigned i = 0; i < 2; ++i) {
      send(false);
      receive(false);
      clear(false);
      if (interface.linked()) job(sendRk, false), job(fetchRk, false), serve(false);
    }
  }
  std::string send(bool request, bool reset = false) {
    return shown(sender.call(control(request, reset), source, length, blocks, now));
  }
  // "DONE 0000 5": with LEN where there is one.
  std::string receive(bool enable, bool reset = false) {
    const auto result = receiver.call(control(enable, reset), target, blocks);
    received = result.length;
    return shown(result.answer);
  }
  std::string clear(bool request, bool reset = false) {
    return shown(clearer.call(control(request, reset)));
  }
  std::string job(LinkJobBlock& block, bool request, bool reset = false) {
    return shown(block.call(control(request, reset), link, source, blocks, now));
  }
  std::string serve(bool enable, bool reset = false) {
    const auto result = server.call(control(enable, reset), memory, now);
    served = result.job;
    return shown(result.answer);
  }
  // Calls `call` each millisecond until it shows something; how many calls that took.
  template <typename Call>
  std::pair<std::string, unsigned> until(Coupled& lines, const Call& call, unsigned most = 5'000) {
    for (unsigned i = 1; i <= most; ++i) {
      now = lines.now;
      const std::string result = call(i == 1);
      if (result != "-") return {result, i};
      lines.run(1);
    }
    return {"-", most};
  }
  Control control(bool request, bool reset) const {
    return {.instance = instance, .request = request, .reset = reset, .permitted = permitted};
  }

  Interface interface;
  SendBlock sender;
  ReceiveBlock receiver;
  ClearBlock clearer;
  LinkJobBlock sendRk, fetchRk;
  ServeBlock server;
  Blocks blocks;
  Areas memory;
  Place source{10, 0}, target{20, 0};
  LinkRequest link;
  std::int32_t length = 1, received = 0;
  std::optional<LinkJob> served;
  std::uint32_t instance = 60;
  bool permitted = true;
  Instant now;
};

inline Parameters of(Protocol protocol, bool high = true) {
  Parameters parameters = defaults(protocol);
  parameters.procedure.highPriority = high;
  return parameters;
}

}  // namespace merker::serial
