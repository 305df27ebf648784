// What programming devices want of a PLC, as orders.
#include "served/blocks.h"
#include "served/exchange.h"
#include "served/system.h"

namespace merker::served {

using s7comm::Controlled;
using s7comm::Error;

void Exchange::status(std::uint16_t list, std::uint16_t index, StatusDone done) {
  order([list, index, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::optional<s7comm::StatusList> found;
    if (monitor != nullptr) found = statusList(monitor->plc(), list, index);
    return [found = std::move(found), done] { done(found); };
  });
}

void Exchange::clock(ClockDone done) {
  order([done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const auto time = monitor == nullptr ? std::nullopt : clockOf(monitor->plc());
    return [time, done] { done(time); };
  });
}

void Exchange::setClock(const s7comm::ClockTime& time, Done done) {
  order([time, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error =
        monitor == nullptr ? Error::CannotBeDone : served::setClock(monitor->plc(), time);
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

void Exchange::block(s7comm::BlockType type, std::uint16_t number, bool wholly, BlockDone done) {
  order([type, number, wholly, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    Uploaded found;
    if (monitor != nullptr) found = blockOf(monitor->plc(), type, number, wholly);
    return [found = std::move(found), done] { done(found.error, found.container); };
  });
}

void Exchange::control(s7comm::Control wish, std::function<void(Controlled)> done) {
  order([wish, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Controlled how =
        monitor == nullptr ? Controlled::Refused : served::control(*monitor, wish);
    return [how, done] { done(how); };
  });
}

}  // namespace merker::served
