#include "cp_sockets.h"

#include <fmt/format.h>

#include <iostream>

#include "server/guard.h"

namespace merker::app {

void tellNoPort(const CpPlace& place, const std::string& why) {
  std::cerr << fmt::format("merker: connection {} of the CP: port {} of {} cannot be used: {}\n",
                           place.parameters().id, place.parameters().localPort, place.address, why);
}

std::shared_ptr<CpSocket> CpSockets::socketOf(std::size_t i) {
  const CpPlace place{context_, lines_, i, address_};
  const CpConnectionParameters& parameters = place.parameters();
  if (hmi::isLocalAddress(address_) && !hmi::isLocalAddress(parameters.host)) {
    std::cerr << fmt::format(
        "merker: connection {} of the CP: {} is another computer, which only "
        "--s7 with an address for others reaches\n",
        parameters.id, parameters.host);
    return nullptr;
  }
  if (parameters.kind == ConnectionKind::Mail) return mailsOf(place);
  return parameters.kind == ConnectionKind::Udp ? datagramsOf(place) : streamOf(place);
}

void CpSockets::use(const std::vector<CpConnectionParameters>& connections) {
  close();
  lines_.configure(connections, [this] {
    for (const auto& one : sockets_) one->move();
  });
  for (std::size_t i = 0; i < lines_.count(); ++i)
    if (auto socket = socketOf(i)) sockets_.push_back(std::move(socket));
  look();
}

void CpSockets::look() {
  for (const auto& one : sockets_) one->look();
}

void CpSockets::close() {
  for (const auto& one : sockets_) one->close();
  sockets_.clear();
}

}  // namespace merker::app
