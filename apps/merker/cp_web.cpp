#include "cp_web.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>

#include "itcp/site.h"
#include "server/page_server.h"

namespace merker::app {
namespace {

// Names of pages are looked up again so often: look() comes four times a second.
constexpr unsigned kLooksOfNames = 8;

std::string urlOf(const std::string& address, std::uint16_t port) {
  const bool six = address.find(':') != std::string::npos;
  return fmt::format("http://{}{}{}:{}/", six ? "[" : "", address, six ? "]" : "", port);
}

}  // namespace

struct CpWeb::One {
  One(served::Exchange& plc, CpWebParameters wanted)
      : parameters(std::move(wanted)), site(std::make_shared<itcp::Site>(plc, parameters.folder)) {}

  CpWebParameters parameters;
  std::shared_ptr<itcp::Site> site;
  std::optional<hmi::PageServer> server;
  bool listens = false, told = false;
};

CpWeb::CpWeb(boost::asio::io_context& context, served::Exchange& plc, std::string address)
    : context_(context), plc_(plc), address_(std::move(address)) {}

CpWeb::~CpWeb() = default;

void CpWeb::use(const std::vector<CpWebParameters>& servers) {
  servers_.clear();
  for (const CpWebParameters& one : servers) servers_.push_back(std::make_unique<One>(plc_, one));
}

void CpWeb::listen(One& one) {
  const std::uint16_t port = one.parameters.port;
  if (!one.server) one.server.emplace(context_, address_, *one.site);
  const std::string why = one.server->listen(port);
  const bool now = why.empty() && !std::exchange(one.listens, why.empty());
  if (now)
    std::cerr << fmt::format("Web server of the CP in slot {}: {}\n", one.parameters.slot,
                             urlOf(address_, port));
  if (!why.empty() && !std::exchange(one.told, true))
    std::cerr << fmt::format(
        "merker: web server of the CP in slot {}: port {} of {} cannot be "
        "used: {}\n",
        one.parameters.slot, port, address_, why);
}

void CpWeb::look(bool powered) {
  const bool names = ++looks_ % kLooksOfNames == 0;
  for (const auto& one : servers_) {
    if (!powered) {
      one->server.reset();
      continue;
    }
    listen(*one);
    one->site->forgetState();
    if (names) one->site->forgetNames();
  }
}

}  // namespace merker::app
