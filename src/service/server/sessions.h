// Connections: HTTP until a browser asks for the WebSocket.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <list>
#include <memory>

#include "server/browsers.h"
#include "server/guard.h"
#include "server/options.h"
#include "server/pages.h"

namespace merker::hmi {

// A connection that is no open browser: a request has to come, or it is being closed.
class Unfinished {
 public:
  virtual ~Unfinished() = default;
  virtual void giveUp() = 0;

 protected:
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
};

// What all connections share; it outlives them.
struct Surroundings {
  const Options& options;
  Guard guard;
  Browsers& browsers;
  Handler& handler;
  boost::asio::ssl::context* tls;  // null: without
  std::atomic<std::size_t> connections = 0;
  std::list<Unfinished*> unfinished{};  // the oldest one first; in the server's thread
};

void serve(boost::asio::ip::tcp::socket socket, Surroundings& around);

// The same of a server of pages.
struct PageSurroundings {
  Limits limits;
  Guard guard;
  Pages* pages;                       // null: the server has gone
  std::list<Unfinished*> sessions{};  // the oldest one first
};
void servePages(boost::asio::ip::tcp::socket socket,
                const std::shared_ptr<PageSurroundings>& around);

}  // namespace merker::hmi
