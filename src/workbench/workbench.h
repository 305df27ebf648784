// The workbench without its transport: requests of browsers in, answers and events out. Time moves
// only in advance(); everything happens in one thread.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/later.h"
#include "workbench/shared.h"

namespace merker::workbench {

class Workbench {
 public:
  using BrowserId = std::uint64_t;

  Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  void use(Workspace workspace) { shared_.workspace = std::move(workspace); }
  // The PLC that everybody sees from now on.
  void show(std::unique_ptr<Plc> plc, bool example = false);
  Plc* plc() { return shared_.plc.get(); }

  void opened(BrowserId browser) { browsers_[browser]; }
  void closed(BrowserId browser);

  // Who compiles; without one it is done at once, and no answer comes later.
  void compileBy(Worker worker);
  // The answer to one message. Whatever it contains, there is one; empty: among the later ones.
  std::string handle(BrowserId browser, std::string_view message);
  // Answers of requests whose compilation is done by now.
  std::vector<std::pair<BrowserId, std::string>> laterAnswers();
  // Begins a frame: what all browsers see in the same moment. `nowMs`: time on the wall.
  void beginFrame(std::int64_t nowMs);
  // What this browser has not seen yet, as texts to send.
  std::vector<std::string> events(BrowserId browser);

  // One slice of virtual time. True: there is more to do at once.
  bool advance(const Pacer::WallClock& wall, Duration longest);

 private:
  Answer run(BrowserId id, const Json& request);
  std::string answerText(std::int64_t id, Answer answer);
  std::string settle(Waiting waiting);
  void sampleTrends();
  void reached(cpu::CyclePoint point);
  void play();
  void addLists(Browser& browser, std::vector<std::string>& texts);
  void addProcess(Browser& browser, std::vector<std::string>& texts);

  Shared shared_;
  std::map<BrowserId, Browser> browsers_;
  std::vector<Waiting> waiting_;
  Json state_;
  std::int64_t nowMs_ = 0, nextLook_ = 0;
};

}  // namespace merker::workbench
