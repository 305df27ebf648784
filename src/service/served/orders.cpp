// What programming devices want of a PLC, as orders.
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

void Exchange::control(s7comm::Control wish, std::function<void(Controlled)> done) {
  order([wish, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Controlled how =
        monitor == nullptr ? Controlled::Refused : served::control(*monitor, wish);
    return [how, done] { done(how); };
  });
}

}  // namespace merker::served
