#include "served/partners.h"

#include <iterator>
#include <utility>

#include "plc/capability.h"
#include "station/block_cpu.h"
#include "system/connections.h"

namespace merker::served {
namespace {

template <class List>
void append(List& to, List& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// Behind what has not been carried yet.
void appendOrders(s7comm::ToPartner& to, s7comm::ToPartner from) {
  if (from.restart) to = {.restart = true};
  append(to.receivers, from.receivers);
  append(to.jobs, from.jobs);
  append(to.aborted, from.aborted);
}

}  // namespace

Partners::~Partners() = default;

void Partners::connectBy(std::function<void(Call)> post, Call wake) {
  post_ = std::move(post);
  wake_ = std::move(wake);
}

void Partners::configure(const std::vector<ConnectionParameters>& connections) {
  for (const auto& end : ends_) end->partner.detach();
  std::vector<std::unique_ptr<End>> ends;
  for (const ConnectionParameters& one : connections)
    ends.push_back(std::make_unique<End>(*this, one));
  const std::lock_guard lock(mutex_);
  ends_.swap(ends);
  stale_ = false;
}

const ConnectionParameters& Partners::parameters(std::size_t connection) const {
  return ends_[connection]->parameters;
}

s7comm::Partner& Partners::partner(std::size_t connection) { return ends_[connection]->partner; }

template <class Change>
void Partners::tell(const Change& change) {
  {
    const std::lock_guard lock(mutex_);
    change();
  }
  wake_();
}

void Partners::End::connected(bool is) {
  owner.tell([&] { news.connected = is; });
}
void Partners::End::finished(s7comm::PartnerResult result) {
  owner.tell([&] { news.results.push_back(std::move(result)); });
}
void Partners::End::begun(std::uint32_t rid, std::size_t octets) {
  owner.tell([&] { news.begun[rid] = octets; });
}
void Partners::End::arrived(s7comm::Telegram telegram) {
  owner.tell([&] {
    news.begun.erase(telegram.rid);
    news.telegrams.push_back(std::move(telegram));
  });
}

void Partners::End::noticed(s7comm::Notice notice) {
  owner.tell([&] { news.note(std::move(notice)); });
}

void Partners::forget() {
  const std::lock_guard lock(mutex_);
  stale_ = true;
}

// News first: what they make the program want is carried at the next end of a cycle.
void Partners::exchange(controller::Controller& plc) {
  bool ordered = false;
  {
    const std::lock_guard lock(mutex_);
    if (stale_ || ends_.empty()) return;
    auto* const cpu = controller::capability<station::BlockCpu>(plc);
    if (cpu == nullptr) return;
    system::Connections& program = cpu->connections();
    for (std::size_t i = 0; i < ends_.size() && i < program.count(); ++i) {
      program.bring(i, std::exchange(ends_[i]->news, {}));
      appendOrders(ends_[i]->orders, program.ordered(i));
      ordered |= !ends_[i]->orders.empty();
    }
  }
  if (ordered) post_([this] { carry(); });
}

void Partners::carry() {
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    std::unique_lock lock(mutex_);
    s7comm::ToPartner orders = std::exchange(ends_[i]->orders, {});
    lock.unlock();
    if (!orders.empty()) ends_[i]->partner.order(std::move(orders));
  }
}

}  // namespace merker::served
