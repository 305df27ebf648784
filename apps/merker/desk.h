// Where the threads of the workbench meet: the server's brings requests, the PLC's answers them
// between two slices of virtual time, three more do what takes longer than a slice.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "server/server.h"
#include "watchdog.h"
#include "work_thread.h"
#include "workbench/workbenches.h"

namespace merker::app {

class Desk : public hmi::Handler {
 public:
  Desk(workbench::Workbenches& workbenches, Watchdog& watchdog);

  // Until `ended`, which is asked between any two pieces of work.
  void run(hmi::Server& server, const std::function<bool()>& ended);

  void eachSlice(std::function<void()> action) { eachSlice_ = std::move(action); }
  // Whether somebody waits for the end of a cycle: pauses are short then.
  void waitedFor(std::function<bool()> question) { waitedFor_ = std::move(question); }
  // From any thread: there is something to do in front of the next slice.
  void hurry();

  // hmi::Handler, in the server's thread
  void opened(hmi::BrowserId browser) override;
  bool received(hmi::BrowserId browser, std::string text) override;
  void closed(hmi::BrowserId browser) override;

 private:
  using Ended = std::function<bool()>;
  // A long message that the clerk reads.
  struct Reading {
    workbench::Work task;
    std::shared_ptr<workbench::Request> request;
    std::size_t bytes = 0;
  };
  // What a browser has sent and nobody has handled.
  struct Inbox {
    std::deque<std::string> texts;
    std::size_t bytes = 0;
    bool paused = false;             // nothing more is read from it
    std::optional<Reading> reading;  // of the first text
  };
  struct Message {
    hmi::BrowserId browser = 0;
    std::string text;
    std::shared_ptr<workbench::Request> request;  // in place of the text
  };

  void wake();
  void greet();
  bool handleSome(hmi::Server& server, const Ended& enough);
  std::optional<Message> next(hmi::Server& server);
  bool ready(hmi::BrowserId browser, Inbox& inbox);
  Message taken(hmi::BrowserId browser, Inbox& inbox, hmi::Server& server);
  void handle(Message message, hmi::Server& server);
  bool frame(hmi::Server& server, const Ended& enough);
  void wait();

  workbench::Workbenches& workbenches_;
  Watchdog& watchdog_;
  std::function<void()> eachSlice_;  // in front of each slice of time
  std::function<bool()> waitedFor_ = [] { return false; };
  WorkThread compiler_, clerk_, importer_;
  std::set<hmi::BrowserId> browsers_, unframed_;  // unframed_: this frame is still to be told to
  hmi::BrowserId current_ = 0, last_ = 0;         // that is served, that was served
  std::int64_t nextFrame_ = 0;

  std::mutex mutex_;  // of what follows
  std::condition_variable arrived_;
  bool fresh_ = false;
  std::map<hmi::BrowserId, Inbox> inboxes_;
  std::deque<std::pair<hmi::BrowserId, bool>> comings_;  // false: it has gone
};

}  // namespace merker::app
