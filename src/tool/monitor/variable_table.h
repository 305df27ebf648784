// A variable table (VAT): operands with their format, monitored and modified at a trigger point
// (S7-SIM-12). Values move only when the CPU comes by that point, or at once on demand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/value.h"
#include "plc/cycle_points.h"
#include "scenario/term.h"

namespace merker::monitor {

using controller::CyclePoint;

// What a table needs of a machine.
class CycleAccess {
 public:
  virtual ~CycleAccess() = default;
  virtual controller::Controller& machine() = 0;
  // Why this value cannot be written here; what is forced takes none.
  virtual std::optional<Problem> checkValue(const address::Reference& reference,
                                            const Value& value) const = 0;
  virtual std::optional<Problem> checkWrite(const address::Reference& reference) const = 0;
  // At a cycle point. Inputs: their process image, which this cycle works with; the terminals stay.
  // What is forced stays as it is.
  virtual void modifyInCycle(const address::Reference& reference, const Value& value) = 0;
};

// Hears that the CPU has come to a point.
class PointWatcher {
 public:
  virtual ~PointWatcher() = default;
  virtual void reached(CyclePoint point) = 0;
};

struct VariableRow {
  address::Reference operand;
  DisplayFormat format = DisplayFormat::Automatic;
  std::optional<Value> status;  // as the monitor trigger saw it last
  std::optional<Value> modify;  // what the modify trigger writes
};

struct Trigger {
  CyclePoint point = CyclePoint::End;
  bool once = false;  // else every time
};

class VariableTable {
 public:
  VariableTable(CycleAccess& access, simulator::Resolver resolver)
      : access_(access), resolver_(std::move(resolver)) {}

  // The problem if there is no such operand or the format does not fit it. A variable of a block
  // (#name) is that of the block which runs when it is looked at.
  std::optional<Problem> add(std::string_view operand,
                             DisplayFormat format = DisplayFormat::Automatic);
  std::optional<Problem> setFormat(std::size_t row, DisplayFormat format);
  // An empty text takes the modify value away.
  std::optional<Problem> setModify(std::size_t row, std::string_view value);
  void remove(std::size_t row) { rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row)); }
  // Rows from this one on.
  void shorten(std::size_t rows) {
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(rows), rows_.end());
  }
  const std::vector<VariableRow>& rows() const { return rows_; }
  // The status in the row's format; "?" before the first look or if the operand does not exist.
  std::string text(std::size_t row) const;

  void monitor(std::optional<Trigger> trigger) { monitor_ = trigger; }  // nothing: off
  void modify(std::optional<Trigger> trigger) { modify_ = trigger; }
  bool monitoring() const { return monitor_.has_value(); }
  bool modifying() const { return modify_.has_value(); }
  void monitorNow();
  void modifyNow();  // inputs: the terminals

  // The CPU has come to this point.
  void reached(CyclePoint point);

 private:
  CycleAccess& access_;
  simulator::Resolver resolver_;
  std::vector<VariableRow> rows_;
  std::optional<Trigger> monitor_, modify_;
};

}  // namespace merker::monitor
