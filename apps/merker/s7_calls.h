// Calls the partners of configured connections, those that this side builds up, again and again
// until they answer.
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <vector>

#include "s7_connection.h"

namespace merker::app {

class S7Calls {
 public:
  using Take = std::function<void(std::shared_ptr<S7Connection>)>;

  // `outside`: partners on other computers are called, too.
  S7Calls(boost::asio::io_context& context, S7Surroundings& around, bool outside)
      : context_(context), around_(around), outside_(outside) {}

  // Every now and then; `take` keeps the new ones.
  void look(S7Connection::Clock::time_point now, const Take& take);
  // The connections are others from now on.
  void forget() { calls_.clear(); }
  std::vector<workbench::S7PartnerRow> rows() const;

 private:
  struct One {
    std::weak_ptr<S7Connection> running{};
    S7Connection::Clock::time_point next{};
  };
  bool mayCall(const ConnectionParameters& parameters) const;

  boost::asio::io_context& context_;
  S7Surroundings& around_;
  bool outside_;
  std::vector<One> calls_;
};

}  // namespace merker::app
