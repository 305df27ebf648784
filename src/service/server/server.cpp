#include "server/server.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <thread>

#include "server/sessions.h"
#include "server/tls.h"

namespace merker::hmi {

namespace net = boost::asio;
using net::ip::tcp;

struct Server::Parts {
  Parts(const Options& o, Handler& handler, std::unique_ptr<net::ssl::context> secure)
      : options(o),
        tls(std::move(secure)),
        around{
            options,
            Guard(isLocalAddress(options.address), tls != nullptr, options.token, options.address),
            browsers, handler, tls.get()} {}

  Options options;
  std::unique_ptr<net::ssl::context> tls;
  Browsers browsers{options.limits.browsers};
  Surroundings around;
  net::io_context context{1};
  tcp::acceptor acceptor{context};
  std::thread thread;

  bool listen(std::string& reason);
  void accept();
};

namespace {

std::string whyNotListening(const Options& options, const boost::system::error_code& error) {
  const bool busy = error == net::error::address_in_use;
  return fmt::format("port {} of {} {}", options.port, options.address,
                     busy ? "is in use by another program; choose another one with --port, or any "
                            "free one with --port 0"
                          : "cannot be used: " + error.message());
}

}  // namespace

bool Server::Parts::listen(std::string& reason) {
  boost::system::error_code error;
  const auto address = net::ip::make_address(numeric(options.address), error);
  if (error) {
    reason = fmt::format("'{}' is not a valid address; write 127.0.0.1, 0.0.0.0 or ::1",
                         options.address);
    return false;
  }
  const tcp::endpoint endpoint(address, options.port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(tcp::acceptor::max_listen_connections, error);
  if (error) reason = whyNotListening(options, error);
  return !error;
}

void Server::Parts::accept() {
  acceptor.async_accept([this](boost::system::error_code error, tcp::socket socket) {
    if (error == net::error::operation_aborted) return;
    if (!error) serve(std::move(socket), around);
    accept();
  });
}

std::unique_ptr<Server> Server::start(const Options& options, Handler& handler,
                                      std::string& reason) {
  if (!(reason = wrongOptions(options)).empty()) return nullptr;
  const bool secure = !options.certificate.empty() && !options.key.empty();
  std::unique_ptr<net::ssl::context> tls;
  if (secure && !(tls = makeTls(options.certificate, options.key, reason))) return nullptr;
  auto parts = std::make_unique<Parts>(options, handler, std::move(tls));
  if (!parts->listen(reason)) return nullptr;
  parts->accept();
  parts->thread = std::thread([context = &parts->context] { context->run(); });
  return std::unique_ptr<Server>(new Server(std::move(parts)));
}

Server::Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Server::~Server() {
  net::post(parts_->context, [parts = parts_.get()] {
    boost::system::error_code ignored;
    parts->acceptor.close(ignored);
    for (const auto& connection : parts->browsers.all()) connection->close();
    parts->context.stop();
  });
  parts_->thread.join();
}

std::string Server::url() const {
  boost::system::error_code ignored;
  const auto endpoint = parts_->acceptor.local_endpoint(ignored);
  const std::string address = endpoint.address().to_string();
  return fmt::format("{}://{}:{}", parts_->tls ? "https" : "http",
                     endpoint.address().is_v6() ? "[" + address + "]" : address, endpoint.port());
}

void Server::send(BrowserId browser, std::string text) {
  const auto waiting = parts_->browsers.waiting(browser);
  if (!waiting) return;
  *waiting += text.size();
  auto shared = std::make_shared<const std::string>(std::move(text));
  net::post(parts_->context, [parts = parts_.get(), browser, shared = std::move(shared)] {
    if (const auto connection = parts->browsers.find(browser)) connection->send(shared);
  });
}

void Server::sendAll(const std::string& text) {
  net::post(parts_->context,
            [parts = parts_.get(), shared = std::make_shared<const std::string>(text)] {
              for (const auto& connection : parts->browsers.all()) {
                *connection->waiting += shared->size();
                connection->send(shared);
              }
            });
}

std::size_t Server::waiting(BrowserId browser) const {
  const auto waiting = parts_->browsers.waiting(browser);
  return waiting ? waiting->load() : 0;
}

void Server::resume(BrowserId browser) {
  net::post(parts_->context, [parts = parts_.get(), browser] {
    if (const auto connection = parts->browsers.find(browser)) connection->resume();
  });
}

}  // namespace merker::hmi
