// Connections of a CP 343-1 to partners outside, between the two threads: what AG_SEND has ordered
// goes out at an end of a cycle, what has come is there for AG_RECV at the next one. Nobody waits
// for the other, and what waits has a limit (SendReceive).
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "catalogue/communication.h"
#include "plc/controller.h"
#include "system/send_receive.h"

namespace merker::served {

class CpLines {
 public:
  using Call = std::function<void()>;
  using Bytes = system::SendReceive::Bytes;

  // As Exchange::connectBy.
  void connectBy(std::function<void(Call)> post, Call wake);

  // In the thread of the connections. `moved`: something is to be sent, or there is room again.
  void configure(const std::vector<CpConnectionParameters>& connections, Call moved);
  std::size_t count() const { return lines_.size(); }
  const CpConnectionParameters& parameters(std::size_t i) const { return lines_[i]->parameters; }
  std::optional<Bytes> toSend(std::size_t i);
  bool hasRoom(std::size_t i);
  bool isConnected(std::size_t i);
  void connected(std::size_t i, bool is);
  void ended(std::size_t i, std::uint16_t result);
  void arrived(std::size_t i, Bytes data);

  // In the thread of the PLC.
  void exchange(controller::Controller& plc);
  // Another PLC is there from now on; configure() comes for it.
  void forget();

 private:
  struct Line {
    CpConnectionParameters parameters;
    bool up = false, changed = true, lost = false;  // since the last exchange
    std::optional<std::uint16_t> result{};
    std::vector<Bytes> in{};
    std::size_t octets = 0;     // in `in`
    std::size_t waiting = 0;    // in the program, by the last exchange
    std::size_t telegrams = 0;  // the same
    std::optional<Bytes> out{};
    bool sends = false;  // the last `out` has not ended
  };
  template <class Change>
  void tell(std::size_t i, const Change& change);
  static bool full(const Line& line);
  static bool carry(Line& line, system::SendReceive::Connection& one);

  std::function<void(Call)> post_ = [](const Call& call) { call(); };
  Call wake_ = [] {}, moved_ = [] {};
  std::mutex mutex_;  // of the lines but for their parameters
  std::vector<std::unique_ptr<Line>> lines_;
  bool stale_ = false;  // they belong to a PLC that has gone
};

}  // namespace merker::served
