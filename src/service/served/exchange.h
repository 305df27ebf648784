// Where the thread of the connections and that of the PLC meet. Reads are answered from a copy of
// the last cycle's end; what changes the PLC, or needs it, is an order that the PLC's thread
// carries out at the end of a cycle, or at once while no cycle runs. The answer goes back to the
// thread of the connections.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>

#include "monitor/monitor.h"
#include "s7comm/plc.h"
#include "served/bench.h"
#include "served/copy.h"
#include "served/cp_lines.h"
#include "served/messages.h"
#include "served/partners.h"
#include "served/passive_blocks.h"
#include "served/resources.h"
#include "served/tasks.h"
#include "system/communication.h"

namespace merker::served {

class Exchange final : public s7comm::Plc {
 public:
  using Call = std::function<void()>;

  // `post` carries a call into the thread of the connections; `wake` tells that of the PLC that
  // there are orders. Before anybody connects.
  void connectBy(std::function<void(Call)> post, Call wake);

  // In the thread of the connections.
  void opened();
  void closed();
  // Configured connections; they do without opened() and closed().
  Partners& partners() { return partners_; }
  // The same of a CP.
  CpLines& cpLines() { return cpLines_; }
  // How many connections of each kind there are: the system status list has it.
  void inUse(const Resources::Counts& connections);
  // The interface that clients come by; nothing: it is none of IP version 4.
  void reachedBy(const std::optional<system::EthernetInterface>& ethernet);
  void read(const std::vector<s7comm::Range>& ranges, ReadDone done) override;
  void write(std::vector<s7comm::Write> writes, WriteDone done) override;
  void status(std::uint16_t list, std::uint16_t index, StatusDone done) override;
  void clock(ClockDone done) override;
  void setClock(const s7comm::ClockTime& time, const std::string& password, Done done) override;
  void subscribe(const std::shared_ptr<s7comm::Outlet>& client, std::optional<std::uint8_t> job,
                 s7comm::CyclicRead read, SubscribeDone done) override;
  void unsubscribe(const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t job,
                   Done done) override;
  void listen(const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t kinds,
              Done done) override;
  void acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) override;
  void lock(std::vector<std::uint32_t> numbers, bool locked, CodesDone done) override;
  void alarms(AlarmsDone done) override;
  void enter(const std::string& password, Done done) override;
  void blocks(BlocksDone done) override;
  void blockHead(const s7comm::BlockName& name, BlockDone done) override;
  void block(const s7comm::BlockName& name, const std::string& password, BlockDone done) override;
  void admit(const s7comm::BlockName& name, std::size_t octets, const std::string& password,
             Done done) override;
  void keep(const s7comm::BlockName& name, s7comm::Bytes container, const std::string& password,
            Done done) override;
  void link(const std::vector<s7comm::BlockName>& names, const std::string& password,
            Done done) override;
  void remove(const std::vector<s7comm::BlockName>& names, const std::string& password,
              Done done) override;
  void control(s7comm::Control wish, const std::string& password,
               std::function<void(s7comm::Controlled)> done) override;
  void test(s7comm::TestRequest request, std::shared_ptr<s7comm::Outlet> client,
            TestDone done) override;

  // What somebody else wants to know of the PLC. Called in its thread, between two cycles, with
  // null if there is none or its cycle does not end; what it returns is called in the thread of the
  // connections.
  using Order = std::function<Call(monitor::Monitor*)>;
  void order(Order order);

  // In the thread of the PLC. At each end of a cycle:
  void cycleEnded(monitor::Monitor& monitor);
  // In front of each slice of time: where no cycle will end, what waits is done now. Null: there is
  // no PLC.
  void look(monitor::Monitor* monitor);
  // An order waits for the end of a cycle. From any thread.
  bool waits() const { return ordered_; }
  // The PLC has power, or there is none. From any thread.
  bool reachable() const { return reachable_; }
  // Another PLC is there from now on.
  void forget();

 private:
  // Planned in the thread of the PLC, made ready in that of the connections, carried out.
  using Plan = std::function<ProgramChange(controller::Controller&)>;
  void changeProgram(Plan plan, Done done);
  // The same of an order of which only its error is told.
  void orderError(std::function<s7comm::Error(monitor::Monitor&)> what, Done done);
  void carryOut(monitor::Monitor* monitor);
  void publish(const controller::Controller& plc);
  void tellConnections(controller::Controller& plc);
  bool stands(const controller::Controller& plc);
  // Nothing: the values are not in the copy.
  std::optional<std::vector<s7comm::Value>> copied(const std::vector<s7comm::Range>& ranges);
  void exchangeConfigured(controller::Controller& plc);

  std::function<void(Call)> post_ = [](const Call& call) { call(); };
  Call wake_ = [] {};
  std::atomic<unsigned> connections_ = 0;
  std::atomic<bool> ordered_ = false, counted_ = false, reachable_ = true;

  Partners partners_;
  CpLines cpLines_;

  mutable std::mutex mutex_;  // of what follows
  std::shared_ptr<Copy> image_;
  PeripheryWatch periphery_;
  std::deque<Order> orders_;
  Resources::Counts inUse_{};
  std::optional<system::EthernetInterface> ethernet_{};

  // of the thread of the PLC
  std::shared_ptr<Copy> spare_;
  MessageLog messages_;
  Tasks tasks_;
  Bench bench_{tasks_};
  PassiveBlocks passive_;
  Instant lastLook_ = Instant::never(), waitingSince_ = Instant::never();
};

}  // namespace merker::served
