// The workbench without its transport: requests of browsers in, answers and events out. Time moves
// only in advance(); everything happens in one thread.
#pragma once

#include <functional>
#include <map>
#include <optional>
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
  void use(Workspace workspace);
  // The PLC that everybody sees from now on.
  void show(std::shared_ptr<Plc> plc, bool example = false);
  void show(std::shared_ptr<Laboratory> lab);
  Plc* plc() const { return shared_.plc.get(); }
  // Null: its project has one station only. And which of them is shown.
  std::shared_ptr<Laboratory> laboratory() const { return shared_.lab; }
  std::size_t station() const { return shared_.station; }
  // Of the project that is open; empty: none is.
  std::string folder() const;
  std::size_t browsers() const { return browsers_.size(); }
  // It is one of several, and has this number.
  void among(Neighbours* neighbours, std::size_t number) {
    shared_.neighbours = neighbours;
    shared_.plcNumber = number;
  }

  void opened(BrowserId browser) { browsers_[browser]; }
  void closed(BrowserId browser);

  // Who compiles, who does what else takes long, who packs and imports projects; without them it is
  // done at once, and no answer comes later.
  void compileBy(Worker worker);
  void helpBy(Worker worker);
  void importBy(Worker worker);
  // Says what the serial interface is connected to.
  void s7By(std::function<S7Outside()> tell) { shared_.s7Outside = std::move(tell); }
  void serialBy(std::function<SerialOutside()> tell) { shared_.serialOutside = std::move(tell); }
  // Counts the PLCs that were shown.
  std::uint64_t shown() const { return shared_.shown; }
  // Hears what begins, so that somebody can say what does not end.
  void tellPlace(std::function<void(std::string_view place)> tell) { tell_ = std::move(tell); }

  // Asked between two pieces of work.
  using Enough = std::function<bool()>;
  static bool never() { return false; }

  // The answer to one message. Whatever it contains, there is one; empty: among the later ones.
  std::string handle(BrowserId browser, std::string_view message);
  std::string handle(BrowserId browser, Request request);
  // The next request of this browser must wait for the answer to one before it.
  bool busy(BrowserId browser) const;
  // Answers of requests that are done by now.
  std::vector<std::pair<BrowserId, std::string>> laterAnswers(const Enough& enough = never);
  // Begins a frame: what all browsers see in the same moment. `nowMs`: time on the wall.
  void beginFrame(std::int64_t nowMs);
  // What this browser has not seen yet, as texts to send; what is too much comes another time.
  std::vector<std::string> events(BrowserId browser, const Enough& enough = never);

  // One slice of virtual time. True: there is more to do at once.
  bool advance(const Pacer::WallClock& wall, Duration longest);

 private:
  void enter(std::string_view place) {
    if (tell_) tell_(place);
  }
  Answer run(Waiting& waiting);
  Answer settle(const Waiting& waiting);
  std::string proceed(Waiting waiting, Answer answer, Instant now);
  void park(Waiting waiting);
  std::string answerText(std::int64_t id, Answer answer);
  void dropWaiting(BrowserId browser);
  void sampleTrends();
  void reached(monitor::CyclePoint point);
  void stepOn(const Enough& enough);
  void settleOn(const Enough& enough);
  void play(const Enough& enough);
  void playOn(Waiting one, Answer answer);
  Instant nextAction() const;
  void addLists(Browser& browser, std::vector<std::string>& texts, const Enough& enough);
  void readProcess();
  void addProcess(Browser& browser, std::vector<std::string>& texts);
  void readStations();
  void addStations(Browser& browser, std::vector<std::string>& texts);
  void readSerial();
  void addSerial(Browser& browser, std::vector<std::string>& texts);

  Shared shared_;
  std::map<BrowserId, Browser> browsers_;
  std::vector<Waiting> waiting_;
  std::optional<Waiting> playing_;  // an action of a recording
  std::function<void(std::string_view)> tell_;
  Json state_;
  std::shared_ptr<const Json> process_;  // as read last
  Json serialLine_, stations_;
  std::int64_t nowMs_ = 0, nextLook_ = 0, nextSerial_ = 0, nextStations_ = 0;
};

}  // namespace merker::workbench
