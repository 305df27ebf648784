// Values that one browser looks at; it hears of those that changed since it last heard.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/json.h"
#include "workbench/plc.h"

namespace merker::workbench {

struct WatchItem {
  std::string operand;
  monitor::DisplayFormat format = monitor::DisplayFormat::Automatic;
  std::optional<Problem> problem;  // why it is never looked at
};

// What it takes to hold them: operands, and bytes of their names.
struct WatchExtent {
  std::size_t items = 0, bytes = 0;
  WatchExtent& operator+=(const WatchExtent& more) {
    items += more.items, bytes += more.bytes;
    return *this;
  }
};

class WatchList {
 public:
  // `trigger`: values are those of that point of the cycle; without: of the moment of telling.
  WatchList(std::vector<WatchItem> items, std::int64_t everyMs,
            std::optional<monitor::Trigger> trigger = {});

  // Binds the operands to the program that the CPU has now. What each is, or its problem.
  Json describe(const Plc& plc);
  // [[index, text, raw], …] of what changed; empty if nothing did. `nowMs` is time on the wall.
  Json changes(const Plc& plc, std::uint64_t program, std::int64_t nowMs);
  // The CPU has come to this point.
  void reached(const Plc& plc, monitor::CyclePoint point);
  WatchExtent extent() const;
  // How many values it reads at a trigger point of each cycle.
  std::size_t atPoint() const { return trigger_ ? rows_.size() : 0; }
  // A trigger that counts once has come.
  bool done() const { return done_; }

 private:
  struct Row {
    WatchItem item;
    std::optional<address::Reference> reference;
    std::optional<monitor::Value> last, seen;  // told, at the trigger point
    bool told = false;
  };
  Json describe(Row& row, const Plc& plc);
  void bind(const Plc& plc, std::uint64_t program);
  static std::optional<monitor::Value> read(const Row& row, const Plc& plc);

  std::vector<Row> rows_;
  std::optional<monitor::Trigger> trigger_;
  bool came_ = false, done_ = false;
  std::int64_t everyMs_, next_ = 0;
  std::uint64_t program_ = 0;
};

// The value as a number: unsigned bits, REAL as a number, null for longer ones.
Json rawValue(const address::Reference& reference, const monitor::Value& value,
              monitor::DisplayFormat format);

}  // namespace merker::workbench
