// The web server of a CP 343-1 IT without its sockets: pages of the user, and /cpu.html and
// /cpu.json with the state of the CPU. All of it in the thread of the connections.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "itcp/cpu_facts.h"
#include "itcp/page_files.h"
#include "itcp/page_values.h"
#include "server/pages.h"

namespace merker::itcp {

class Site final : public hmi::Pages, public std::enable_shared_from_this<Site> {
 public:
  // `folder`: of the user's pages, or none. The PLC outlives it.
  Site(served::Exchange& plc, std::string folder);

  void opened() override { plc_.opened(); }
  void closed() override { plc_.closed(); }
  void page(const std::string& target, Done done) override;

  // Now and then: the state of the CPU is asked for once for all who want it until then.
  void forgetState() { facts_.reset(); }
  // More seldom: another program may have come.
  void forgetNames() { values_->forget(); }

 private:
  using FactsDone = std::function<void(const CpuFacts&)>;
  void facts(FactsDone done);
  void cpu(bool asJson, Done done);
  void file(PageFile file, Done done);

  served::Exchange& plc_;
  std::string folder_;
  std::shared_ptr<PageValues> values_;
  std::optional<CpuFacts> facts_;
  std::vector<FactsDone> waiting_;  // for the facts that have been asked for
};

}  // namespace merker::itcp
