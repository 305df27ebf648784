// S7 basic communication of a CPU over MPI (SFC 65 to 69): its jobs, the connections that it and
// its partners have, the queue of SFC 66. Telegrams that have arrived are looked at when a cycle
// ends, in calls of these functions, and at once while the CPU is in STOP.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "network/node.h"
#include "system/basic_messages.h"

namespace merker::cpu {
class Cpu;
}

namespace merker::system {

// RET_VAL of these functions (System Software for S7-300/400, 22.2).
namespace basic {
constexpr std::uint32_t kIdle = 0x7000, kBegun = 0x7001, kRuns = 0x7002;
constexpr std::uint32_t kNoAddress = 0x8090, kBadData = 0x8092;
constexpr std::uint32_t kBroken = 0x80A1;    // the connection has ended
constexpr std::uint32_t kNoObject = 0x80B0;  // at the partner: no such data block
constexpr std::uint32_t kBadLength = 0x80B1, kReadOnly = 0x80B3, kBadType = 0x80B4,
                        kStopped = 0x80B5;
constexpr std::uint32_t kDiscarded = 0x80B8;  // the partner took no data: RD is NIL
constexpr std::uint32_t kNotTaken = 0x80B9;   // seen by EN_DT = 0, but not taken before STOP
constexpr std::uint32_t kTooLong = 0x80BA;
constexpr std::uint32_t kBusy = 0x80C0, kNoResources = 0x80C1, kPartnerFull = 0x80C2,
                        kUnreachable = 0x80C3;
}  // namespace basic

class BasicCommunication {
 public:
  static constexpr std::uint32_t kLongest = 76;  // bytes of a job (S7-LIM-02)
  static constexpr std::uint32_t kHighestAddress = 126;

  // What a call of SFC 65, 67 or 68 wants.
  struct Order {
    MessageKind kind = MessageKind::Send;
    std::uint8_t partner = 0;
    bool begin = false, keep = false;  // REQ, CONT
    std::uint32_t id = 0;
    AnyPointer there{};
    std::vector<std::uint8_t> data{};
    std::uint32_t dataError = 0;  // why SD or RD is impossible; 0: it is possible
  };
  // What has been sent for SFC 66.
  struct Received {
    std::uint8_t from = 0;
    std::uint16_t job = 0;
    std::uint32_t id = 0;
    std::vector<std::uint8_t> data{};
    bool seen = false;  // EN_DT = 0 has told of it
  };

  // `connections`: of this CPU at most, to and from partners.
  void join(network::Node& node, std::size_t connections);
  bool joined() const { return node_ != nullptr; }
  const network::Node* node() const { return node_; }
  bool reads(const network::Node& node) const { return node_ == &node; }
  // No partner, no job, no telegram: only a call of the program makes it send something.
  bool idle() const {
    return links_.empty() && partners_.empty() && queue_.empty() && others_.empty() &&
           wishes_.empty() && (node_ == nullptr || node_->idle());
  }

  // RET_VAL. Of SFC 67 with 0: `answer` is what the partner sent.
  std::uint32_t call(const Order& order, Instant now, std::vector<std::uint8_t>& answer);
  std::uint32_t abort(std::uint8_t partner, bool begin, Instant now);
  Received* oldest() { return queue_.empty() ? nullptr : &queue_.front(); }
  // The oldest one is gone; its sender learns `code`.
  void finishOldest(std::uint32_t code, Instant now);

  // A telegram of another kind, to all: the node has one reader.
  void sendToAll(std::vector<std::uint8_t> data, Instant now) {
    node_->send(now, network::kEveryone, std::move(data));
  }
  std::deque<network::Telegram>& others() { return others_; }

  // What has arrived by `now`; variables are read and written by serve() only.
  void receive(Instant now);
  void serve(cpu::Cpu& cpu, Instant now);
  // The CPU is in STOP; without power nobody hears and nobody answers.
  void rest(cpu::Cpu& cpu, Instant now, bool powered);
  // A warm or cold restart.
  void restart();
  Instant next() const { return node_ == nullptr ? Instant::never() : node_->next(); }

 private:
  struct Link {  // to a partner, made by this CPU
    bool connected = false, keep = false, aborting = false;
    std::optional<BasicMessage> job;     // what is wanted
    std::optional<BasicMessage> answer;  // it is over
    Instant deadline{};
  };
  struct Wish {
    std::uint8_t from = 0;
    BasicMessage message;
  };

  bool full() const { return links_.size() + partners_.size() >= connections_; }
  std::uint32_t begin(const Order& order, Instant now);
  std::uint32_t finish(std::uint8_t partner, std::vector<std::uint8_t>& answer, Instant now);
  void send(std::uint8_t to, const BasicMessage& message, Instant now);
  void answer(std::uint8_t to, std::uint16_t job, std::uint32_t code, Instant now,
              std::vector<std::uint8_t> data = {});
  void handle(std::uint8_t from, BasicMessage message, Instant now);
  void connect(std::uint8_t from, const BasicMessage& message, Instant now);
  void end(std::uint8_t from);
  void over(std::uint8_t partner, std::uint32_t code, std::vector<std::uint8_t> data = {});
  void fulfil(cpu::Cpu& cpu, const Wish& wish, Instant now);

  network::Node* node_ = nullptr;
  std::size_t connections_ = 127;  // a CPU without a subnet tries in vain
  std::map<std::uint8_t, Link> links_;
  std::set<std::uint8_t> partners_;  // that have a connection to this CPU
  std::deque<Received> queue_;
  std::deque<network::Telegram> others_;
  std::deque<Wish> wishes_;  // X_GET, X_PUT of partners
  std::uint16_t lastJob_ = 0;
  bool stopped_ = false;
};

}  // namespace merker::system
