// The runs of a campaign on all cores: processes that do some of them each, and the lines that come
// from them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "campaign_child.h"

namespace merker::app {

class CampaignPool {
 public:
  // Outcomes that have arrived; false ends it.
  using Take = std::function<bool(const std::vector<campaign::Arrived>&)>;
  // Asked several times a second; true ends it.
  using Stop = std::function<bool()>;

  CampaignPool(const campaign::Plan& plan, unsigned processes, Take take, Stop stop)
      : plan_(plan), processes_(processes), take_(std::move(take)), stop_(std::move(stop)) {}
  ~CampaignPool();
  CampaignPool(const CampaignPool&) = delete;
  CampaignPool& operator=(const CampaignPool&) = delete;

  // False if it was ended early; runs whose outcome has not arrived then have none.
  bool run(std::vector<std::uint64_t> numbers);
  const std::vector<LostRun>& lost() const { return lost_; }

 private:
  struct Process {
    int pid = 0, in = -1;
    std::vector<std::uint64_t> waiting;  // without outcome
    std::string text;                    // a line that is not whole yet
  };
  bool start();  // false: the system has no further process
  void startAll();
  bool exchange();
  bool read(Process& process, std::vector<campaign::Arrived>& arrived);
  void takeLine(Process& process, std::string_view line, std::vector<campaign::Arrived>& arrived);
  void end(Process& process);
  std::size_t portion() const;

  const campaign::Plan& plan_;
  unsigned processes_;
  Take take_;
  Stop stop_;
  std::vector<std::uint64_t> numbers_;  // the next ones at the end
  std::vector<std::unique_ptr<Process>> running_;
  std::vector<LostRun> lost_;
};

}  // namespace merker::app
