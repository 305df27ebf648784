// Cyclic reads: a task each, in the time of the PLC.
#pragma once

#include "s7comm/plc.h"
#include "served/tasks.h"

namespace merker::served {

class CyclicTask final : public Task {
 public:
  static constexpr std::size_t kMost = 32;  // of a connection

  CyclicTask(std::shared_ptr<s7comm::Outlet> client, std::uint8_t number)
      : Task(std::move(client)), number_(number) {}

  std::uint8_t number() const { return number_; }
  bool onChange() const { return read_.onChange; }
  // From now on; the values that its client gets first.
  std::vector<s7comm::Value> set(s7comm::CyclicRead read, const controller::Controller& plc);
  bool run(monitor::Monitor& monitor) override;

 private:
  std::uint8_t number_;
  s7comm::CyclicRead read_;
  Instant next_ = Instant::never();
  std::vector<s7comm::Value> last_;
};

struct Subscribed {
  s7comm::Error error = s7comm::Error::None;
  std::uint8_t job = 0;
  std::vector<s7comm::Value> values{};
};
// Without a number: a new one.
Subscribed subscribe(Tasks& tasks, const controller::Controller& plc,
                     const std::shared_ptr<s7comm::Outlet>& client,
                     std::optional<std::uint8_t> number, const s7comm::CyclicRead& read);
s7comm::Error unsubscribe(Tasks& tasks, monitor::Monitor& monitor, const s7comm::Outlet& client,
                          std::uint8_t number);

}  // namespace merker::served
