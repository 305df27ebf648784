// The open WebSockets: asked from the thread of the PLC, filled by that of the server.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "hmi/handler.h"

namespace merker::hmi {

class Connection {
 public:
  virtual ~Connection() = default;
  virtual void send(std::shared_ptr<const std::string> text) = 0;  // in the server's thread
  virtual void resume() = 0;                                       // reads on
  virtual void close() = 0;

  std::atomic<std::size_t> waiting = 0;  // bytes not yet handed to the operating system
};

class Browsers {
 public:
  explicit Browsers(std::size_t most) : most_(most) {}
  // 0: there are too many.
  BrowserId add(const std::shared_ptr<Connection>& connection);
  void remove(BrowserId id);
  std::shared_ptr<Connection> find(BrowserId id) const;
  std::vector<std::shared_ptr<Connection>> all() const;

 private:
  std::size_t most_;
  mutable std::mutex mutex_;
  BrowserId last_ = 0;
  std::map<BrowserId, std::weak_ptr<Connection>> open_;
};

}  // namespace merker::hmi
