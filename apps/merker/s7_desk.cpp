#include "s7_desk.h"

#include <iostream>

#include "command.h"

namespace merker::app {

int S7Desk::open(const std::string& command, const S7Option& option,
                 const CommunicationParameters& parameters, std::function<void()> wake,
                 std::string station) {
  if (option.place.empty()) return kGood;
  if (!station.empty()) title_ += " of " + std::move(station);
  std::string reason;
  const auto place = s7Place(option, reason);
  if (place) server_ = S7Server::start(*place, parameters, std::move(wake), reason);
  if (!server_) {
    std::cerr << command << ": " << reason << '\n';
    return place ? kUnreadable : kUsage;
  }
  std::cerr << title_ << ": " << server_->place() << std::endl;
  if (const std::string warning = server_->warning(); !warning.empty())
    std::cerr << command << ": warning: " << warning << std::endl;
  return kGood;
}

workbench::S7Outside S7Desk::outside() const {
  return server_ ? server_->outside() : workbench::S7Outside{};
}

S7Desk::~S7Desk() {
  if (server_) std::cerr << title_ << ": " << server_->summary() << std::endl;
}

void S7Desk::follow(workbench::Plc* plc) {
  server_->exchange().forget();
  if (plc == nullptr) return;
  server_->use(plc->build().project.communication);
  plc->onCycle(cycleObserver(plc->monitor()));
}

void S7Desk::exchange(workbench::Plc* plc, bool fresh) {
  if (!server_) return;
  if (fresh) follow(plc);
  server_->exchange().look(plc == nullptr ? nullptr : &plc->monitor());
}

void S7Desk::exchange(monitor::Monitor& monitor) {
  if (server_) server_->exchange().look(&monitor);
}

bool S7Desk::waits() const { return server_ && server_->exchange().waits(); }

std::function<void(controller::Controller&)> S7Desk::cycleObserver(
    monitor::Monitor& monitor) const {
  return [server = std::weak_ptr(server_), &monitor](controller::Controller&) {
    if (const auto there = server.lock()) there->exchange().cycleEnded(monitor);
  };
}

}  // namespace merker::app
