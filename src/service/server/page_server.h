// A web server of pages: listens, in the thread of its context, without TLS. It only reads; whoever
// it does not know by one of its own names is refused (guard.h).
#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "server/options.h"
#include "server/pages.h"

namespace merker::hmi {

class PageServer {
 public:
  // Few people look at the pages of a CP at the same time.
  static constexpr Limits kFew{.connections = 32};

  // `pages` and the context outlive it.
  PageServer(boost::asio::io_context& context, std::string address, Pages& pages,
             const Limits& limits = kFew);
  ~PageServer();  // all connections are closed
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  // Empty, or why it cannot listen; then it may be tried again.
  std::string listen(std::uint16_t port);

 private:
  struct Parts;
  std::shared_ptr<Parts> parts_;
};

}  // namespace merker::hmi
