// A PLC of each family with its monitor behind an exchange; one thread is both.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "compilation/build.h"
#include "served/exchange.h"

namespace merker::served {

using s7comm::Bytes;
using s7comm::ItemCode;
using s7comm::Memory;
using s7comm::Range;
using s7comm::Value;

// MB 10 at the begin of each cycle and MB 11 at its end count cycles; DB 5 begins with 01 02 03 04.
inline const char* const kStation =
    "DATA_BLOCK DB 5\nSTRUCT\n a : DWORD := DW#16#01020304;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L MB 10;\n + 1;\n T MB 10;\n T MB 11;\n"
    " L S5T#9S;\n U M 0.0;\n SE T 3;\n U E 0.0;\n = A 0.0;\nEND_ORGANIZATION_BLOCK\n";
inline const char* const kControl =
    "DB 5\n 0: KH = 0102\n 1: KH = 0304\n"
    "OB 1\n L MB 10\n L KF +1\n +F\n T MB 10\n T MB 11\n"
    " U M 0.0\n L KT 090.1\n SE T 3\n U E 0.0\n = A 0.0\n BE\n";

class ServedPlc {
 public:
  explicit ServedPlc(const std::string& name, const std::string& text)
      : build_(compilation::build(project::load(name, {}, {{name, text}}), false)) {
    for (const Problem& problem : build_.problems.list())
      if (problem.severity() == Severity::Error) ADD_FAILURE() << problem.message;
    plc_ = build_.controller();
    monitor_ = monitor::monitorOf(*plc_, build_.project.symbols, build_.resolver());
    plc_->onCycle([this](controller::Controller&) { exchange.cycleEnded(*monitor_); });
    plc_->memoryReset();
    plc_->start();
  }
  static ServedPlc station(const std::string& text = kStation) { return ServedPlc("a.awl", text); }
  static ServedPlc control(const std::string& text = kControl) { return ServedPlc("a.s5", text); }
  ServedPlc(const ServedPlc&) = delete;

  controller::Controller& plc() { return *plc_; }
  monitor::Monitor& monitor() { return *monitor_; }
  void cycles(std::uint64_t count) { plc_->advanceCycles(count); }
  void look() { exchange.look(monitor_.get()); }

  // Nothing: it waits.
  std::optional<Value> read(const Range& range) {
    const auto result = std::make_shared<std::optional<Value>>();
    exchange.read({range}, [result](const std::vector<Value>& values) { *result = values.at(0); });
    waiting = result;
    return *result;
  }
  std::shared_ptr<std::optional<Value>> waiting;
  std::optional<ItemCode> write(const Range& range, Bytes octets) {
    const auto result = std::make_shared<std::optional<ItemCode>>();
    exchange.write({{range, std::move(octets)}},
                   [result](const std::vector<ItemCode>& codes) { *result = codes.at(0); });
    written = result;
    return *result;
  }
  std::shared_ptr<std::optional<ItemCode>> written;
  // Over the next end of a cycle.
  ItemCode writeNow(const Range& range, Bytes octets) {
    write(range, std::move(octets));
    cycles(1);
    return written->value_or(ItemCode::Requested);
  }

  Exchange exchange;

 private:
  compilation::Build build_;
  std::unique_ptr<controller::Controller> plc_;
  std::unique_ptr<monitor::Monitor> monitor_;
};

inline Range flags(std::uint32_t begin, std::uint32_t octets) {
  return {.memory = Memory::Flag, .begin = begin, .octets = octets};
}

enum class Family : std::uint8_t { Station, Control };
class EachFamily : public ::testing::TestWithParam<Family> {
 protected:
  ServedPlc plc{GetParam() == Family::Station ? "a.awl" : "a.s5",
                GetParam() == Family::Station ? kStation : kControl};
};

}  // namespace merker::served
