#include "laboratory_s7.h"

#include <algorithm>
#include <memory>

#include "command.h"

namespace merker::app {

int LaboratoryS7::open(const std::string& command, const S7Option& option,
                       std::function<void()> wake) {
  if (option.place.empty()) return kGood;
  const auto lab = workbench_.laboratory();
  const auto first = firstS7Place(command, option, lab ? lab->plcs.size() : 1);
  if (!first) return kUsage;
  command_ = command;
  first_ = *first;
  wake_ = std::move(wake);
  return add(lab.get());
}

// Servers stay when their stations have gone: clients find them at the same ports.
int LaboratoryS7::add(const Laboratory* lab) {
  const std::size_t stations = lab == nullptr ? 1 : std::min(lab->plcs.size(), kMostS7Stations);
  for (std::size_t i = desks_.size(); i < stations; ++i) {
    workbench::Plc* const plc = plcOf(lab, i);
    const auto parameters = plc == nullptr ? CommunicationParameters::of(defaultCpuModel())
                                           : plc->build().project.communication;
    const std::string name = lab == nullptr ? std::string() : lab->build.stations[i].name;
    const int bad =
        desks_.emplace_back().open(command_, s7OptionOf(first_, i), parameters, wake_, name);
    if (bad != kGood) return desks_.pop_back(), bad;
  }
  return kGood;
}

workbench::Plc* LaboratoryS7::plcOf(const Laboratory* lab, std::size_t i) const {
  if (lab != nullptr) return i < lab->plcs.size() ? lab->plcs[i].get() : nullptr;
  return i == 0 ? workbench_.plc() : nullptr;
}

void LaboratoryS7::follow(const std::shared_ptr<Laboratory>& lab) {
  lab_ = lab;
  (void)add(lab.get());  // what has no free port is not served; it is told
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
