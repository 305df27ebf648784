#include "campaign_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace merker::app {

CampaignPool::~CampaignPool() {
  for (const auto& process : running_) {
    kill(process->pid, SIGKILL);
    close(process->in);
    while (waitpid(process->pid, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

// Many at once, so that runs with the same beginning share it; few towards the end, so that all
// processes end at the same time.
std::size_t CampaignPool::portion() const {
  constexpr std::size_t kMost = 64, kTurns = 4;
  return std::clamp<std::size_t>(numbers_.size() / (kTurns * processes_), 1, kMost);
}

bool CampaignPool::start() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
  auto process = std::make_unique<Process>();
  const std::size_t count = std::min(portion(), numbers_.size());
  process->waiting.assign(numbers_.rbegin(),
                          numbers_.rbegin() + static_cast<std::ptrdiff_t>(count));
  const int parent = getpid();
  process->pid = fork();
  if (process->pid == 0) {
    close(ends[0]);
    for (const auto& other : running_) close(other->in);
    doRuns(plan_, process->waiting, ends[1], parent);
  }
  close(ends[1]);
  if (process->pid < 0) {
    close(ends[0]);
    return false;
  }
  numbers_.resize(numbers_.size() - count);
  process->in = ends[0];
  running_.push_back(std::move(process));
  return true;
}

void CampaignPool::startAll() {
  while (running_.size() < processes_ && !numbers_.empty())
    if (!start()) {
      if (!running_.empty()) return;  // later
      for (const std::uint64_t number : numbers_)
        lost_.push_back({number, std::string("no process for it: ") + std::strerror(errno)});
      numbers_.clear();
    }
}

void CampaignPool::takeLine(Process& process, std::string_view line,
                            std::vector<campaign::Arrived>& arrived) {
  const auto lost = decodeLost(line);
  auto outcome = lost ? std::nullopt : campaign::decode(line);
  if (!lost && !outcome) return;
  std::erase(process.waiting, lost ? lost->number : outcome->number);
  if (lost) lost_.push_back(*lost);
  if (outcome) arrived.push_back(std::move(*outcome));
}

// False at the end.
bool CampaignPool::read(Process& process, std::vector<campaign::Arrived>& arrived) {
  std::array<char, 65'536> bytes{};
  const ssize_t count = ::read(process.in, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR;
  process.text.append(bytes.data(), static_cast<std::size_t>(count));
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = process.text.find('\n', begin)) != std::string::npos;
       begin = end + 1)
    takeLine(process, std::string_view(process.text).substr(begin, end - begin), arrived);
  process.text.erase(0, begin);
  return count > 0;
}

// Runs that it has left without a word are lost for the same reason.
void CampaignPool::end(Process& process) {
  close(process.in);
  int status = 0;
  while (waitpid(process.pid, &status, 0) < 0 && errno == EINTR) {
  }
  for (const std::uint64_t number : process.waiting)
    lost_.push_back({number, whyEnded(status, plan_.definition())});
}

bool CampaignPool::exchange() {
  constexpr int kLook = 50;  // ms
  std::vector<pollfd> places;
  for (const auto& process : running_) places.push_back({process->in, POLLIN, 0});
  if (poll(places.data(), places.size(), kLook) < 0 && errno != EINTR) return false;
  std::vector<campaign::Arrived> arrived;
  for (std::size_t i = places.size(); i > 0; --i) {
    if (places[i - 1].revents == 0) continue;
    if (read(*running_[i - 1], arrived)) continue;
    end(*running_[i - 1]);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i - 1));
  }
  return take_(arrived);
}

bool CampaignPool::run(std::vector<std::uint64_t> numbers) {
  numbers_ = std::move(numbers);
  std::ranges::reverse(numbers_);
  for (startAll(); !running_.empty(); startAll())
    if (!exchange() || stop_()) return false;
  return true;
}

}  // namespace merker::app
