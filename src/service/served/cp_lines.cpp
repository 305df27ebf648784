#include "served/cp_lines.h"

#include <utility>

#include "plc/capability.h"
#include "station/block_cpu.h"

namespace merker::served {

using system::SendReceive;

void CpLines::connectBy(std::function<void(Call)> post, Call wake) {
  post_ = std::move(post);
  wake_ = std::move(wake);
}

void CpLines::configure(const std::vector<CpConnectionParameters>& connections, Call moved) {
  std::vector<std::unique_ptr<Line>> lines;
  for (const CpConnectionParameters& one : connections)
    lines.push_back(std::make_unique<Line>(Line{.parameters = one}));
  const std::lock_guard lock(mutex_);
  lines_.swap(lines);
  moved_ = std::move(moved);
  stale_ = false;
}

template <class Change>
void CpLines::tell(std::size_t i, const Change& change) {
  {
    const std::lock_guard lock(mutex_);
    change(*lines_[i]);
  }
  wake_();
}

void CpLines::connected(std::size_t i, bool is) {
  tell(i, [&](Line& line) {
    line.lost |= line.up && !is;
    line.changed = true;
    line.up = is;
    if (is) return;
    line.out.reset();
    line.sends = false;
  });
}

void CpLines::ended(std::size_t i, std::uint16_t result) {
  tell(i, [&](Line& line) {
    line.result = result;
    line.sends = false;
  });
}

void CpLines::arrived(std::size_t i, Bytes data) {
  tell(i, [&](Line& line) {
    line.octets += data.size();
    line.in.push_back(std::move(data));
  });
}

std::optional<CpLines::Bytes> CpLines::toSend(std::size_t i) {
  const std::lock_guard lock(mutex_);
  return std::exchange(lines_[i]->out, std::nullopt);
}

// One more block of data of the longest kind would not fit.
bool CpLines::full(const Line& line) {
  return line.waiting + line.octets + SendReceive::kLongest > SendReceive::kMostWaiting ||
         line.telegrams + line.in.size() >= SendReceive::kMostTelegrams;
}

bool CpLines::hasRoom(std::size_t i) {
  const std::lock_guard lock(mutex_);
  return !full(*lines_[i]);
}

bool CpLines::isConnected(std::size_t i) {
  const std::lock_guard lock(mutex_);
  return lines_[i]->up;
}

void CpLines::forget() {
  const std::lock_guard lock(mutex_);
  stale_ = true;
}

// True: the thread of the connections has something to do.
bool CpLines::carry(Line& line, SendReceive::Connection& one) {
  const bool wasFull = full(line);
  if (line.result) SendReceive::ended(one, *std::exchange(line.result, std::nullopt));
  if (std::exchange(line.lost, false)) SendReceive::connected(one, false);
  if (std::exchange(line.changed, false)) SendReceive::connected(one, line.up);
  for (Bytes& data : std::exchange(line.in, {})) SendReceive::arrived(one, std::move(data));
  line.octets = 0;
  line.waiting = one.waiting;
  line.telegrams = one.in.size();
  const bool begins = one.out.has_value() && line.up && !line.sends;
  if (begins) line.out = std::exchange(one.out, std::nullopt);
  line.sends |= begins;
  return begins || (wasFull && !full(line));
}

void CpLines::exchange(controller::Controller& plc) {
  bool moved = false;
  {
    const std::lock_guard lock(mutex_);
    if (stale_ || lines_.empty()) return;
    auto* const cpu = controller::capability<station::BlockCpu>(plc);
    if (cpu == nullptr) return;
    SendReceive& program = cpu->sendReceive();
    for (std::size_t i = 0; i < lines_.size() && i < program.count(); ++i)
      moved |= carry(*lines_[i], program.at(i));
  }
  if (moved) post_([this] { moved_(); });
}

}  // namespace merker::served
