// What goes on in the PLC for a client, until it is over: cyclic reads, status of variables,
// messages. How a service uses it: its order (Exchange) calls `tasks_.begin(std::make_shared<…>(
// client, …))`, `client` being the Outlet that the session gave along; from then on `run` is called
// at each end of a cycle, and while none runs in front of each slice of time, with the virtual time
// in `monitor.plc().now()`. It sends with `client().send({group, subfunction, sequence, …})`: what
// does not fit any more is lost (false), and `run` says whether it goes on. With its connection, or
// with the PLC, every task ends.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "monitor/monitor.h"
#include "s7comm/outlet.h"

namespace merker::served {

class Task {
 public:
  explicit Task(std::shared_ptr<s7comm::Outlet> client) : client_(std::move(client)) {}
  virtual ~Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  // False: it is over.
  virtual bool run(monitor::Monitor& monitor) = 0;
  // It is over, the PLC is still there.
  virtual void end(monitor::Monitor&) {}
  s7comm::Outlet& client() const { return *client_; }

 private:
  friend class Tasks;
  std::shared_ptr<s7comm::Outlet> client_;
};

// In the thread of the PLC.
class Tasks {
 public:
  // Has `call` called in the thread of the connections.
  using Post = std::function<void(std::function<void()> call)>;

  void begin(std::shared_ptr<Task> task) { tasks_.push_back(std::move(task)); }
  // The first one of this client of this kind for which `is` holds; null: there is none.
  template <class Kind>
  Kind* find(const s7comm::Outlet& client, const std::function<bool(Kind&)>& is) const;
  template <class Kind>
  std::size_t count(const s7comm::Outlet& client) const;
  void remove(const Task& task, monitor::Monitor& monitor);
  const std::vector<std::shared_ptr<Task>>& all() const { return tasks_; }

  void run(monitor::Monitor& monitor, const Post& post);
  void clear(monitor::Monitor& monitor);
  void forget() { tasks_.clear(); }  // the PLC has gone

 private:
  std::vector<std::shared_ptr<Task>> tasks_;
};

template <class Kind>
Kind* Tasks::find(const s7comm::Outlet& client, const std::function<bool(Kind&)>& is) const {
  for (const auto& task : tasks_) {
    auto* const one = &task->client() == &client ? dynamic_cast<Kind*>(task.get()) : nullptr;
    if (one != nullptr && is(*one)) return one;
  }
  return nullptr;
}

template <class Kind>
std::size_t Tasks::count(const s7comm::Outlet& client) const {
  std::size_t found = 0;
  find<Kind>(client, [&](Kind&) { return ++found, false; });
  return found;
}

}  // namespace merker::served
