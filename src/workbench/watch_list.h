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
};

class WatchList {
 public:
  WatchList(std::vector<WatchItem> items, std::int64_t everyMs);

  // Binds the operands to the program that the CPU has now. What each is, or its problem.
  Json describe(const Plc& plc);
  // [[index, text, raw], …] of what changed; empty if nothing did. `nowMs` is time on the wall.
  Json changes(const Plc& plc, std::uint64_t program, std::int64_t nowMs);

 private:
  struct Row {
    WatchItem item;
    std::optional<mc7::Reference> reference;
    std::optional<monitor::Value> last;
    bool told = false;
  };
  Json describe(Row& row, const Plc& plc);
  void bind(const Plc& plc, std::uint64_t program);
  static std::optional<monitor::Value> read(const Row& row, const Plc& plc);

  std::vector<Row> rows_;
  std::int64_t everyMs_, next_ = 0;
  std::uint64_t program_ = 0;
};

// The value as a number: unsigned bits, REAL as a number, null for longer ones.
Json rawValue(const mc7::Reference& reference, const monitor::Value& value,
              monitor::DisplayFormat format);

}  // namespace merker::workbench
