// What a CPU tells those who listen: operating modes, entries of the diagnostic buffer, and
// block-related messages (SFC 17, 18, 107, 108), whose only reader is here.
#pragma once

#include <deque>

#include "s7comm/plc.h"
#include "served/tasks.h"

namespace merker::system {
struct AlarmMessage;
}

namespace merker::served {

// The block-related messages of all listeners, the newest ones.
class MessageLog {
 public:
  static constexpr std::size_t kMost = 128;

  // Takes what the CPU has for them.
  void collect(controller::Controller& plc);
  std::uint64_t end() const { return first_ + kept_.size(); }
  // Those from this number on, as far as they are here.
  std::vector<s7comm::Indication> since(std::uint64_t number) const;

 private:
  std::uint64_t first_ = 0;
  std::deque<s7comm::Indication> kept_;
};

class MessageTask final : public Task {
 public:
  MessageTask(std::shared_ptr<s7comm::Outlet> client, std::uint8_t kinds, MessageLog& log,
              controller::Controller& plc);
  bool run(monitor::Monitor& monitor) override;
  void end(monitor::Monitor& monitor) override;

 private:
  bool wants(std::uint8_t kind) const { return (kinds_ & kind) != 0; }
  void sendMode(const controller::Controller& plc);
  void sendEvents(controller::Controller& plc);
  void sendAlarms(controller::Controller& plc);

  std::uint8_t kinds_;
  MessageLog& log_;
  std::uint64_t nextAlarm_ = 0, events_ = 0;
  controller::Mode mode_;
};

// In place of what the client had before.
s7comm::Error listen(Tasks& tasks, MessageLog& log, monitor::Monitor& monitor,
                     const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t kinds);
std::vector<s7comm::ItemCode> acknowledgeAlarms(controller::Controller& plc,
                                                const std::vector<std::uint32_t>& numbers);
std::vector<s7comm::ItemCode> lockAlarms(controller::Controller& plc,
                                         const std::vector<std::uint32_t>& numbers, bool locked);
// Nothing: a machine without such messages.
std::optional<std::vector<s7comm::AlarmState>> alarmsOf(controller::Controller& plc);

}  // namespace merker::served
