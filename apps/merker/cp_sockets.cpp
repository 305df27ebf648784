#include "cp_sockets.h"

#include <fmt/format.h>

#include <iostream>
#include <utility>

#include "server/guard.h"

namespace merker::app {

void tellNoPort(const CpPlace& place, const std::string& why) {
  std::cerr << fmt::format("merker: connection {} of the CP: port {} of {} cannot be used: {}\n",
                           place.parameters().id, place.parameters().localPort, place.address, why);
}

bool CpSockets::reaches(std::size_t i) const {
  return !hmi::isLocalAddress(address_) || hmi::isLocalAddress(lines_.parameters(i).host);
}

std::shared_ptr<CpSocket> CpSockets::socketOf(std::size_t i) {
  const CpPlace place{context_, lines_, i, address_};
  const CpConnectionParameters& parameters = place.parameters();
  if (parameters.kind == ConnectionKind::Mail) return mailsOf(place);
  return parameters.kind == ConnectionKind::Udp ? datagramsOf(place) : streamOf(place);
}

void CpSockets::use(const std::vector<CpConnectionParameters>& connections) {
  close();
  lines_.configure(connections, [this] {
    for (const auto& one : sockets_) one->move();
  });
  for (std::size_t i = 0; i < lines_.count(); ++i)
    if (!reaches(i))
      std::cerr << fmt::format(
          "merker: connection {} of the CP: {} is another computer, which only "
          "--s7 with an address for others reaches\n",
          lines_.parameters(i).id, lines_.parameters(i).host);
}

void CpSockets::open() {
  if (std::exchange(open_, true)) return;
  for (std::size_t i = 0; i < lines_.count(); ++i)
    if (reaches(i)) sockets_.push_back(socketOf(i));
}

void CpSockets::look(bool powered) {
  if (!powered) return close();
  open();
  for (const auto& one : sockets_) one->look();
}

std::vector<workbench::CpConnectionRow> CpSockets::rows() const {
  std::vector<workbench::CpConnectionRow> rows;
  for (std::size_t i = 0; i < lines_.count(); ++i)
    rows.push_back({lines_.parameters(i).id, lines_.isConnected(i)});
  return rows;
}

void CpSockets::close() {
  open_ = false;
  for (const auto& one : sockets_) one->close();
  sockets_.clear();
}

}  // namespace merker::app
