#include "server/page_server.h"

#include <boost/asio/ip/tcp.hpp>
#include <utility>

#include "server/sessions.h"

namespace merker::hmi {

namespace net = boost::asio;
using net::ip::tcp;

struct PageServer::Parts : std::enable_shared_from_this<PageServer::Parts> {
  Parts(net::io_context& context, std::string where, Pages& pages, const Limits& limits)
      : address(std::move(where)),
        acceptor(context),
        around(std::make_shared<PageSurroundings>(PageSurroundings{
            limits, Guard(isLocalAddress(address), false, {}, address), &pages})) {}

  std::string address;
  tcp::acceptor acceptor;
  std::shared_ptr<PageSurroundings> around;

  void close() {
    boost::system::error_code ignored;
    acceptor.close(ignored);
  }
  void accept() {
    acceptor.async_accept(
        [self = shared_from_this()](boost::system::error_code error, tcp::socket socket) {
          if (error == net::error::operation_aborted || self->around->pages == nullptr) return;
          if (error) return self->close();  // no more descriptors, say: it is tried again
          servePages(std::move(socket), self->around);
          self->accept();
        });
  }
};

PageServer::PageServer(net::io_context& context, std::string address, Pages& pages,
                       const Limits& limits)
    : parts_(std::make_shared<Parts>(context, std::move(address), pages, limits)) {}

PageServer::~PageServer() {
  parts_->close();
  Pages& pages = *std::exchange(parts_->around->pages, nullptr);
  for (Unfinished* const session : parts_->around->sessions) {
    session->giveUp();
    pages.closed();
  }
}

std::string PageServer::listen(std::uint16_t port) {
  tcp::acceptor& acceptor = parts_->acceptor;
  if (acceptor.is_open()) return {};
  boost::system::error_code error;
  const tcp::endpoint own(net::ip::make_address(parts_->address), port);
  acceptor.open(own.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(own, error);
  if (!error) acceptor.listen(tcp::acceptor::max_listen_connections, error);
  if (error) {
    parts_->close();
    return error.message();
  }
  parts_->accept();
  return {};
}

}  // namespace merker::hmi
