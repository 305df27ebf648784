// Several projects at once, each with a PLC of its own: a Workbench for each. All move in one
// thread; each browser is at one of them, at the first one when it comes.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>

#include "workbench/neighbours.h"
#include "workbench/workbench.h"

namespace merker::workbench {

class Workbenches : public Neighbours {
 public:
  using BrowserId = Workbench::BrowserId;
  using Enough = Workbench::Enough;
  using LaterAnswers = std::vector<std::pair<BrowserId, std::string>>;

  // `first` has the project of the command line, and outlives this.
  explicit Workbenches(Workbench& first);
  ~Workbenches() override;
  Workbenches(const Workbenches&) = delete;
  Workbenches& operator=(const Workbenches&) = delete;
  void each(const std::function<void(Workbench&)>& action);

  // As of Workbench, at the one where the browser is.
  void opened(BrowserId browser);
  void closed(BrowserId browser);
  std::string handle(BrowserId browser, std::string_view message);
  std::string handle(BrowserId browser, Request request);
  bool busy(BrowserId browser) const { return at(browser).busy(browser); }
  std::vector<std::string> events(BrowserId browser, const Enough& enough);
  // Of all.
  LaterAnswers laterAnswers(const Enough& enough);
  void beginFrame(std::int64_t nowMs);
  // They share the slice.
  bool advance(const Pacer::WallClock& wall, Duration longest);

  // Neighbours
  Json rows() const override;
  std::size_t count() const override;
  std::size_t whoHas(std::string_view folder) const override;
  void move(BrowserId browser, std::size_t number) override { moving_ = {browser, number}; }

 private:
  struct Moving {
    BrowserId browser = 0;
    std::size_t number = 0;
  };

  Workbench& at(BrowserId browser) const;
  std::string moved(std::string answer);

  std::vector<std::unique_ptr<Workbench>> others_;
  std::array<Workbench*, kPlcs> all_{};
  std::map<BrowserId, std::size_t> at_;  // index
  std::optional<Moving> moving_;
};

}  // namespace merker::workbench
