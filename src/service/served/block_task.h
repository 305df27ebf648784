// Block status (S7-EDIT-21): the registers behind the instructions that a client names, of one call
// of the block each time that the job is enabled.
#pragma once

#include <map>

#include "served/test_task.h"

namespace merker::served {

BlockId watchedBlock(const s7comm::BlockWatch& watch);
s7comm::TestRegisters testRegisters(const monitor::Registers& registers);

class BlockTask final : public TestTask, public monitor::InstructionWatcher {
 public:
  BlockTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job, monitor::Monitor& monitor);

  bool run(monitor::Monitor&) override { return !over_; }
  void end(monitor::Monitor& monitor) override;
  // After a download the code is another one: it is looked for again.
  void enable(bool on) override;
  void before(const monitor::Spot& spot) override;
  void after(const monitor::Spot& spot) override;
  bool wanted() const override { return !gone_; }

 private:
  bool isInside(const monitor::Spot& spot) const;
  bool isWanted(const monitor::Spot& spot) const;
  void beginCall(const monitor::Spot& spot);
  void record(std::uint32_t address, const s7comm::TestRegisters& registers);
  void endCall();

  monitor::Monitor& monitor_;
  bool recording_ = false, over_ = false, gone_ = false;
  std::size_t running_ = 0;                  // depth of the call that is under way; 0: none
  std::optional<std::uint32_t> underWay_{};  // an instruction, which may open a block
  s7comm::TestRegisters found_, first_;      // before it; before the first one
  std::map<std::uint32_t, s7comm::TestRegisters> seen_;
};

}  // namespace merker::served
