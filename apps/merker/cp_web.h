// The web servers of the CPs 343-1 IT of a station, in the thread of the S7 server and where that
// listens.
#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "catalogue/communication.h"
#include "served/exchange.h"

namespace merker::app {

class CpWeb {
 public:
  CpWeb(boost::asio::io_context& context, served::Exchange& plc, std::string address);
  ~CpWeb();
  CpWeb(const CpWeb&) = delete;
  CpWeb& operator=(const CpWeb&) = delete;

  // Those of another project close.
  void use(const std::vector<CpWebParameters>& servers);
  // Every now and then; the first time they begin to listen. Without power nobody does.
  void look(bool powered);

 private:
  struct One;
  void listen(One& one);

  boost::asio::io_context& context_;
  served::Exchange& plc_;
  std::string address_;
  std::vector<std::unique_ptr<One>> servers_;
  unsigned looks_ = 0;
};

}  // namespace merker::app
