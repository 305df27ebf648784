// The server: listens, serves the page, and carries texts between browsers and a handler.
#pragma once

#include <memory>
#include <string>

#include "server/handler.h"
#include "server/options.h"

namespace merker::hmi {

class Server {
 public:
  // Null, and the reason, if it cannot listen.
  static std::unique_ptr<Server> start(const Options& options, Handler& handler,
                                       std::string& reason);
  ~Server();  // all connections are closed, the handler is not called again
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::string url() const;  // "http://127.0.0.1:8080"

  // From any thread. Texts for a browser that has gone are lost.
  void send(BrowserId browser, std::string text);
  void sendAll(const std::string& text);
  // Bytes that wait to be sent; none: the browser has read what it got so far.
  std::size_t waiting(BrowserId browser) const;
  // Reads on from a browser of which nothing more was to be read.
  void resume(BrowserId browser);

 private:
  struct Parts;
  explicit Server(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::hmi
