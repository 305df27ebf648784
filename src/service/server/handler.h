// Who answers the browsers. All calls come from the server's thread; they must not block.
#pragma once

#include <cstdint>
#include <string>

namespace merker::hmi {

using BrowserId = std::uint64_t;  // 1, 2 …; never used twice

class Handler {
 public:
  virtual ~Handler() = default;
  virtual void opened(BrowserId browser) = 0;
  // False: nothing more is read from this browser until Server::resume.
  virtual bool received(BrowserId browser, std::string text) = 0;
  virtual void closed(BrowserId browser) = 0;

 protected:
  Handler() = default;
  Handler(const Handler&) = default;
  Handler& operator=(const Handler&) = default;
  Handler(Handler&&) = default;
  Handler& operator=(Handler&&) = default;
};

}  // namespace merker::hmi
