// Where the threads of the workbench meet: the server's brings requests, the PLC's answers them
// between two slices of virtual time.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <set>

#include "compile_thread.h"
#include "hmi/server.h"
#include "workbench/workbench.h"

namespace merker::app {

class Desk : public hmi::Handler {
 public:
  explicit Desk(workbench::Workbench& workbench) : workbench_(workbench) {
    workbench.compileBy([this](workbench::Work work) { compiler_.push(std::move(work)); });
  }

  // Until `ended`, which is asked every few milliseconds.
  void run(hmi::Server& server, const std::function<bool()>& ended);

  // hmi::Handler, in the server's thread
  void opened(hmi::BrowserId browser) override { push({Kind::Opened, browser, {}}); }
  void received(hmi::BrowserId browser, std::string text) override {
    push({Kind::Received, browser, std::move(text)});
  }
  void closed(hmi::BrowserId browser) override { push({Kind::Closed, browser, {}}); }

 private:
  enum class Kind : std::uint8_t { Opened, Received, Closed };
  struct Message {
    Kind kind;
    hmi::BrowserId browser;
    std::string text;
  };
  void push(Message message);
  std::deque<Message> take();
  static void answer(hmi::Server& server, hmi::BrowserId browser, std::string text);
  void handle(const Message& message, hmi::Server& server);
  void frame(hmi::Server& server, std::int64_t now);
  void wait();

  workbench::Workbench& workbench_;
  CompileThread compiler_;
  std::set<hmi::BrowserId> browsers_;
  std::int64_t nextFrame_ = 0;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Message> waiting_;
};

}  // namespace merker::app
