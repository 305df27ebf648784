// What clients want of the blocks of a PLC, as orders.
#include "served/blocks.h"
#include "served/container_check.h"
#include "served/exchange.h"

namespace merker::served {

using s7comm::BlockName;
using s7comm::Error;

void Exchange::orderError(std::function<Error(monitor::Monitor&)> what, Done done) {
  order([what = std::move(what), done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error = monitor == nullptr ? Error::CannotBeDone : what(*monitor);
    return [error, done] { done(error); };
  });
}

void Exchange::blocks(BlocksDone done) {
  order([done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::optional<std::vector<s7comm::BlockEntry>> all;
    if (monitor != nullptr) all = blocksOf(monitor->plc());
    return [all = std::move(all), done] { done(all); };
  });
}

void Exchange::blockHead(const BlockName& name, BlockDone done) {
  order([this, name, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    Uploaded found;
    if (monitor != nullptr) found = blockOf(monitor->plc(), passive_, name);
    return [found = std::move(found), done] { done(found.error, found.container); };
  });
}

void Exchange::block(const BlockName& name, const std::string& password, BlockDone done) {
  order([this, name, password, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    Uploaded found;
    if (monitor != nullptr) found = upload(monitor->plc(), passive_, name, password);
    return [found = std::move(found), done] { done(found.error, found.container); };
  });
}

void Exchange::admit(const BlockName& name, std::size_t octets, const std::string& password,
                     Done done) {
  orderError(
      [this, name, octets, password](monitor::Monitor& monitor) {
        return passive_.admit(monitor.plc(), name, octets, password);
      },
      std::move(done));
}

// Checked here, not in the thread of the PLC.
void Exchange::keep(const BlockName& name, s7comm::Bytes container, const std::string& password,
                    Done done) {
  const std::size_t octets = container.size();
  CheckedBlock checked = checkedBlock(name, std::move(container));
  if (checked.error != Error::None) return done(checked.error);
  orderError(
      [this, block = std::make_shared<const block::Block>(std::move(checked.block)), octets,
       password](monitor::Monitor& monitor) {
        return passive_.keep(monitor.plc(), block, octets, password);
      },
      std::move(done));
}

void Exchange::changeProgram(Plan plan, Done done) {
  order([this, plan = std::move(plan), done = std::move(done)](monitor::Monitor* monitor) -> Call {
    auto change = std::make_shared<ProgramChange>();
    change->error = Error::CannotBeDone;
    if (monitor != nullptr) *change = plan(monitor->plc());
    return [this, plan, done, change] {
      change->makeReady();
      if (change->error != Error::None) return done(change->error);
      order([this, plan, done, change](monitor::Monitor* there) -> Call {
        const bool current = there != nullptr && passive_.carryOut(there->plc(), *change);
        // What it replaced goes in the thread that made it.
        return [this, plan, done, change, current] {
          current ? done(change->error) : changeProgram(plan, done);
        };
      });
    };
  });
}

void Exchange::link(const std::vector<BlockName>& names, const std::string& password, Done done) {
  changeProgram([this, names, password](
                    controller::Controller& plc) { return passive_.link(plc, names, password); },
                std::move(done));
}

void Exchange::remove(const std::vector<BlockName>& names, const std::string& password, Done done) {
  changeProgram([this, names, password](
                    controller::Controller& plc) { return passive_.remove(plc, names, password); },
                std::move(done));
}

}  // namespace merker::served
