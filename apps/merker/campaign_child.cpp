#include "campaign_child.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

namespace merker::app {
namespace {

constexpr char kLost = '!';
constexpr int kDone = 0, kOutOfMemory = 3, kBroken = 4;

void dieWith(int parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kBroken);  // it was quicker
}

// From here on, beside what has been used.
void limitTime(Duration time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto before = static_cast<std::int64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  const auto seconds = static_cast<rlim_t>(before + (time.ns + kSecond - 1) / kSecond + 1);
  const rlimit limit{seconds, RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &limit);
}

// Beside what the process has now; the address sanitizer takes terabytes of addresses.
void limitMemory([[maybe_unused]] std::uint32_t megabytes) {
#ifndef __SANITIZE_ADDRESS__
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur =
      std::min<rlim_t>(limit.rlim_max, pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) +
                                           (rlim_t{megabytes} << 20));
  setrlimit(RLIMIT_AS, &limit);
#endif
}

// Short enough to arrive whole. A reader that is gone ends this process, too.
void send(int out, const std::string& line) {
  while (::write(out, line.data(), line.size()) < 0 && errno == EINTR) {
  }
}

void sendLost(int out, std::uint64_t number, const std::string& why) {
  send(out, fmt::format("{}{}\t{}\n", kLost, number, why));
}

class Worker {
 public:
  Worker(const campaign::Plan& plan, int out) : plan_(plan), out_(out), run_(plan) {}

  // `next`: whether the run behind it has the same beginning.
  void take(std::uint64_t number, bool next) {
    const std::uint64_t beginning = plan_.beginning(number);
    if (begun_ != beginning && next) begin(number, beginning);
    const pid_t self = getpid(), child = fork();
    if (child == 0) doRun(number, begun_ == beginning, self);
    if (child < 0)
      return sendLost(out_, number, fmt::format("no process for it: {}", std::strerror(errno)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != kDone)
      sendLost(out_, number, whyEnded(status, plan_.definition()));
  }

 private:
  void begin(std::uint64_t number, std::uint64_t beginning) {
    limitTime(plan_.definition().timeLimit);
    limitMemory(plan_.definition().memoryLimit);
    run_.begin(plan_.choice(number));
    begun_ = beginning;
  }

  [[noreturn]] void doRun(std::uint64_t number, bool begun, int parent) {
    dieWith(parent);
    limitTime(plan_.definition().timeLimit);
    limitMemory(plan_.definition().memoryLimit);
    try {
      const campaign::Choice choice = plan_.choice(number);
      if (!begun) run_.begin(choice);
      send(out_, campaign::encode(number, run_.end(choice)));
    } catch (const std::bad_alloc&) {
      _exit(kOutOfMemory);
    } catch (...) {
      _exit(kBroken);
    }
    _exit(kDone);
  }

  const campaign::Plan& plan_;
  int out_;
  campaign::Run run_;
  std::optional<std::uint64_t> begun_;
};

}  // namespace

std::optional<LostRun> decodeLost(std::string_view line) {
  LostRun lost;
  if (!line.starts_with(kLost)) return std::nullopt;
  const auto [end, error] =
      std::from_chars(line.data() + 1, line.data() + line.size(), lost.number);
  if (error != std::errc() || end == line.data() + line.size()) return std::nullopt;
  lost.why = std::string(end + 1, line.data() + line.size());
  return lost;
}

std::string whyEnded(int status, const campaign::Definition& definition) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return fmt::format("it needs more than {} s of processor time (time_limit)",
                       definition.timeLimit.ns / 1'000'000'000);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory)
    return fmt::format("it needs more than {} MB of memory (memory_limit)", definition.memoryLimit);
  if (WIFSIGNALED(status))
    return fmt::format("its process was ended by signal {}", WTERMSIG(status));
  return "its process failed";
}

void doRuns(const campaign::Plan& plan, std::span<const std::uint64_t> numbers, int out,
            int parent) {
  dieWith(parent);
  try {
    Worker worker(plan, out);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      worker.take(numbers[i], i + 1 < numbers.size() &&
                                  plan.beginning(numbers[i]) == plan.beginning(numbers[i + 1]));
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (...) {
    _exit(kBroken);
  }
  _exit(kDone);
}

}  // namespace merker::app
