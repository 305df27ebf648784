// What programming devices want of a PLC, as orders.
#include <utility>

#include "served/cyclic.h"
#include "served/exchange.h"
#include "served/system.h"

namespace merker::served {

using s7comm::Controlled;
using s7comm::Error;

void Exchange::status(std::uint16_t list, std::uint16_t index, StatusDone done) {
  order([this, list, index, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    s7comm::StatusList found;
    if (monitor != nullptr) {
      setTestJobs(monitor->plc(), bench_.jobs(*monitor));
      found = statusList(monitor->plc(), list, index);
    }
    return [found = std::move(found), done] { done(found); };
  });
}

void Exchange::clock(ClockDone done) {
  order([done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const auto time = monitor == nullptr ? std::nullopt : clockOf(monitor->plc());
    return [time, done] { done(time); };
  });
}

void Exchange::setClock(const s7comm::ClockTime& time, const std::string& password, Done done) {
  order([time, password, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error =
        monitor == nullptr ? Error::CannotBeDone : served::setClock(monitor->plc(), time, password);
    return [error, done] { done(error); };
  });
}

void Exchange::subscribe(const std::shared_ptr<s7comm::Outlet>& client,
                         std::optional<std::uint8_t> job, s7comm::CyclicRead read,
                         SubscribeDone done) {
  order([this, client, job, read = std::move(read),
         done = std::move(done)](monitor::Monitor* monitor) -> Call {
    Subscribed made{Error::CannotBeDone};
    if (monitor != nullptr)
      made = served::subscribe(tasks_, std::as_const(*monitor).plc(), client, job, read);
    return [made = std::move(made), done] { done(made.error, made.job, made.values); };
  });
}

void Exchange::unsubscribe(const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t job,
                           Done done) {
  order([this, client, job, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error = monitor == nullptr ? Error::CannotBeDone
                                           : served::unsubscribe(tasks_, *monitor, *client, job);
    return [error, done] { done(error); };
  });
}

void Exchange::listen(const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t kinds,
                      Done done) {
  order([this, client, kinds, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error = monitor == nullptr
                            ? Error::CannotBeDone
                            : served::listen(tasks_, messages_, *monitor, client, kinds);
    return [error, done] { done(error); };
  });
}

void Exchange::acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) {
  order([numbers = std::move(numbers), done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::vector<s7comm::ItemCode> codes(numbers.size(), s7comm::ItemCode::HardwareFault);
    if (monitor != nullptr) codes = acknowledgeAlarms(monitor->plc(), numbers);
    return [codes = std::move(codes), done] { done(codes); };
  });
}

void Exchange::lock(std::vector<std::uint32_t> numbers, bool locked, CodesDone done) {
  order([numbers = std::move(numbers), locked,
         done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::vector<s7comm::ItemCode> codes(numbers.size(), s7comm::ItemCode::HardwareFault);
    if (monitor != nullptr) codes = lockAlarms(monitor->plc(), numbers, locked);
    return [codes = std::move(codes), done] { done(codes); };
  });
}

void Exchange::alarms(AlarmsDone done) {
  order([done = std::move(done)](monitor::Monitor* monitor) -> Call {
    std::optional<std::vector<s7comm::AlarmState>> all;
    if (monitor != nullptr) all = alarmsOf(monitor->plc());
    return [all = std::move(all), done] { done(all); };
  });
}

void Exchange::enter(const std::string& password, Done done) {
  order([password, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Error error =
        monitor == nullptr ? Error::CannotBeDone : checkPassword(monitor->plc(), password);
    return [error, done] { done(error); };
  });
}

void Exchange::control(s7comm::Control wish, const std::string& password,
                       std::function<void(Controlled)> done) {
  order([this, wish, password, done = std::move(done)](monitor::Monitor* monitor) -> Call {
    const Controlled how =
        monitor == nullptr ? Controlled::Refused : served::control(*monitor, wish, password);
    if (wish == s7comm::Control::MemoryReset && how == Controlled::Done) passive_.clear();
    return [how, done] { done(how); };
  });
}

void Exchange::test(s7comm::TestRequest request, std::shared_ptr<s7comm::Outlet> client,
                    TestDone done) {
  order([this, request = std::move(request), client = std::move(client),
         done = std::move(done)](monitor::Monitor* monitor) -> Call {
    s7comm::TestAnswer answer{Error::CannotBeDone, 0, {}};
    if (monitor != nullptr) answer = bench_.carryOut(*monitor, request, client);
    return [answer = std::move(answer), done, client] {
      done(answer);
      if (client->announce()) client->deliver();
    };
  });
}

}  // namespace merker::served
