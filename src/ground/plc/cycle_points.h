// Where a variable table monitors and modifies: before OB 1 with fresh inputs, behind OB 1 before
// the outputs go out, at the transition to STOP.
#pragma once

#include <cstdint>
#include <functional>

namespace merker::controller {

enum class CyclePoint : std::uint8_t { Begin, End, Stop };

class CyclePoints {
 public:
  using Monitor = std::function<void(CyclePoint)>;
  void observe(Monitor monitor) { monitor_ = std::move(monitor); }
  bool observed() const { return monitor_ != nullptr; }
  void reached(CyclePoint point) const {
    if (monitor_) monitor_(point);
  }

 private:
  Monitor monitor_;
};

}  // namespace merker::controller
