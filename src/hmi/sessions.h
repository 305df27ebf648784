// Connections: HTTP until a browser asks for the WebSocket.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "hmi/browsers.h"
#include "hmi/guard.h"
#include "hmi/options.h"

namespace merker::hmi {

// What all connections share; it outlives them.
struct Surroundings {
  const Options& options;
  Guard guard;
  Browsers& browsers;
  Handler& handler;
  boost::asio::ssl::context* tls;  // null: without
  std::atomic<std::size_t> connections = 0;
};

void serve(boost::asio::ip::tcp::socket socket, Surroundings& around);

}  // namespace merker::hmi
