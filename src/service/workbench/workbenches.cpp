#include "workbench/workbenches.h"

#include <algorithm>
#include <filesystem>

namespace merker::workbench {
namespace {

bool inUse(const Workbench& one) { return one.plc() != nullptr || one.browsers() > 0; }

std::filesystem::path canonicalPath(std::string_view folder) {
  std::error_code error;
  return std::filesystem::weakly_canonical(folder, error);
}

Json plcRow(const Workbench& one, std::size_t number) {
  const Plc* plc = one.plc();
  return {{"plc", number},
          {"project", plc == nullptr ? "" : plc->build().project.name},
          {"folder", one.folder()},
          {"mode", plc == nullptr ? "" : modeOf(*plc)},
          {"browsers", one.browsers()}};
}

}  // namespace

Workbenches::Workbenches(Workbench& first) {
  all_[0] = &first;
  for (std::size_t i = 1; i < kPlcs; ++i)
    all_[i] = others_.emplace_back(std::make_unique<Workbench>()).get();
  for (std::size_t i = 0; i < kPlcs; ++i) all_[i]->among(this, i + 1);
}

Workbenches::~Workbenches() { all_[0]->among(nullptr, 1); }

void Workbenches::each(const std::function<void(Workbench&)>& action) {
  for (Workbench* one : all_) action(*one);
}

Workbench& Workbenches::at(BrowserId browser) const {
  const auto found = at_.find(browser);
  return *all_[found == at_.end() ? 0 : found->second];
}

void Workbenches::opened(BrowserId browser) {
  at_[browser] = 0;
  at(browser).opened(browser);
}

void Workbenches::closed(BrowserId browser) {
  at(browser).closed(browser);
  at_.erase(browser);
}

std::string Workbenches::handle(BrowserId browser, std::string_view message) {
  return moved(at(browser).handle(browser, message));
}

std::string Workbenches::handle(BrowserId browser, Request request) {
  return moved(at(browser).handle(browser, std::move(request)));
}

// For the PLC that it leaves it is as if the browser had disconnected.
std::string Workbenches::moved(std::string answer) {
  const auto moving = std::exchange(moving_, std::nullopt);
  if (!moving || !at_.contains(moving->browser)) return answer;
  std::size_t& index = at_[moving->browser];
  if (index == moving->number - 1) return answer;
  all_[index]->closed(moving->browser);
  index = moving->number - 1;
  all_[index]->opened(moving->browser);
  return answer;
}

std::vector<std::string> Workbenches::events(BrowserId browser, const Enough& enough) {
  return at(browser).events(browser, enough);
}

Workbenches::LaterAnswers Workbenches::laterAnswers(const Enough& enough) {
  LaterAnswers answers;
  for (Workbench* one : all_)
    for (auto& answer : one->laterAnswers(enough)) answers.push_back(std::move(answer));
  return answers;
}

void Workbenches::beginFrame(std::int64_t nowMs) {
  for (Workbench* one : all_)
    if (one->browsers() > 0) one->beginFrame(nowMs);
}

bool Workbenches::advance(const Pacer::WallClock& wall, Duration longest) {
  const auto busy = std::ranges::count_if(all_, [](Workbench* one) { return one->plc(); });
  const Duration share{longest.ns / std::max<std::int64_t>(busy, 1)};
  bool more = false;
  for (Workbench* one : all_) more = one->advance(wall, share) || more;
  return more;
}

Json Workbenches::rows() const {
  Json rows = Json::array();
  for (std::size_t i = 0; i < kPlcs; ++i) rows.push_back(plcRow(*all_[i], i + 1));
  return rows;
}

std::size_t Workbenches::count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(all_, [](const Workbench* one) { return inUse(*one); }));
}

std::size_t Workbenches::whoHas(std::string_view folder) const {
  for (std::size_t i = 0; i < kPlcs; ++i)
    if (const std::string has = all_[i]->folder();
        !has.empty() && canonicalPath(has) == canonicalPath(folder))
      return i + 1;
  return 0;
}

}  // namespace merker::workbench
