// Pages that are made when somebody asks for them: what the web server of a CP shows.
#pragma once

#include <functional>
#include <string>

namespace merker::hmi {

struct Page {
  unsigned status = 200;  // of HTTP
  std::string type = "text/plain; charset=utf-8";
  std::string bytes{};
};

// All calls come from the thread of the server and return at once.
class Pages {
 public:
  virtual ~Pages() = default;
  // A connection; while there is one, somebody may ask.
  virtual void opened() = 0;
  virtual void closed() = 0;
  using Done = std::function<void(Page)>;
  // `target` as the browser wrote it: "/index.html?x". `done` is called in the same thread, within
  // the call or later, or never.
  virtual void page(const std::string& target, Done done) = 0;

 protected:
  Pages() = default;
  Pages(const Pages&) = default;
  Pages& operator=(const Pages&) = default;
};

}  // namespace merker::hmi
