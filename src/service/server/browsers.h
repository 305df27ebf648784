// The open WebSockets: asked from the thread of the PLC, filled by that of the server.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/handler.h"

namespace merker::hmi {

class Connection {
 public:
  virtual ~Connection() = default;
  virtual void send(std::shared_ptr<const std::string> text) = 0;  // in the server's thread
  virtual void resume() = 0;                                       // reads on
  virtual void close() = 0;

  // Bytes not yet handed to the operating system. Its own: who counts does not keep the connection.
  const std::shared_ptr<std::atomic<std::size_t>> waiting =
      std::make_shared<std::atomic<std::size_t>>(0);
};

class Browsers {
 public:
  explicit Browsers(std::size_t most) : most_(most) {}
  // 0: there are too many.
  BrowserId add(const std::shared_ptr<Connection>& connection);
  void remove(BrowserId id);
  // Connections live and end in the server's thread: only there somebody may hold one.
  std::shared_ptr<Connection> find(BrowserId id) const;
  std::vector<std::shared_ptr<Connection>> all() const;
  // From any thread; null: it has gone.
  std::shared_ptr<std::atomic<std::size_t>> waiting(BrowserId id) const;

 private:
  std::size_t most_;
  mutable std::mutex mutex_;
  BrowserId last_ = 0;
  struct Open {
    std::weak_ptr<Connection> connection;
    std::shared_ptr<std::atomic<std::size_t>> waiting;
  };
  std::map<BrowserId, Open> open_;
};

}  // namespace merker::hmi
