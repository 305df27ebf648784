#include "laboratory_s7.h"

#include <algorithm>
#include <memory>

#include "command.h"

namespace merker::app {

int LaboratoryS7::open(const std::string& command, const S7Option& option,
                       const std::function<void()>& wake) {
  const auto lab = workbench_.laboratory();
  const std::size_t stations = lab ? lab->plcs.size() : 1;
  if (option.place.empty()) return kGood;
  const auto first = firstS7Place(command, option, stations);
  if (!first) return kUsage;
  for (std::size_t i = 0; i < stations; ++i) {
    workbench::Plc* const plc = plcOf(lab.get(), i);
    const auto parameters = plc == nullptr ? CommunicationParameters::of(defaultCpuModel())
                                           : plc->build().project.communication;
    const std::string name = lab ? lab->build.stations[i].name : std::string();
    if (const int bad =
            desks_.emplace_back().open(command, s7OptionOf(*first, i), parameters, wake, name))
      return bad;
  }
  return kGood;
}

workbench::Plc* LaboratoryS7::plcOf(const Laboratory* lab, std::size_t i) const {
  if (lab != nullptr) return i < lab->plcs.size() ? lab->plcs[i].get() : nullptr;
  return i == 0 ? workbench_.plc() : nullptr;
}

void LaboratoryS7::follow(const std::shared_ptr<Laboratory>& lab) {
  lab_ = lab;
  std::vector<S7Server*> servers;
  for (S7Desk& one : desks_) servers.push_back(&one.server());
  if (lab)
    ways_.lay(lab->build, servers);
  else
    ways_ = {}, servers.front()->passOn({});
}

void LaboratoryS7::exchange() {
  if (desks_.empty()) return;
  const auto lab = workbench_.laboratory();
  const bool fresh = lab ? lab_.lock() != lab : workbench_.shown() != shown_;
  shown_ = workbench_.shown();
  if (fresh) follow(lab);
  if (lab) ways_.look(*lab->network);
  for (std::size_t i = 0; i < desks_.size(); ++i) desks_[i].exchange(plcOf(lab.get(), i), fresh);
}

bool LaboratoryS7::waits() const { return std::ranges::any_of(desks_, &S7Desk::waits); }

workbench::S7Outside LaboratoryS7::outside() const {
  if (desks_.empty()) return {};
  const auto lab = workbench_.laboratory();
  const std::size_t shown = lab ? workbench_.station() : 0;
  return shown < desks_.size() ? desks_[shown].outside() : workbench::S7Outside{};
}

}  // namespace merker::app
