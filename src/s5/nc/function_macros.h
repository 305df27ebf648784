// The resident function macros of SINUMERIK 810/820 GA3, FB 11 … FB 190, with the NC they work on
// (6.3, S5-FM). One object belongs to one PLC and outlives it.
#pragma once

#include <functional>

#include "nc/control.h"
#include "nc/coupling.h"
#include "nc/data_exchange.h"
#include "nc/flag_stack.h"
#include "softplc/processor.h"

namespace merker::nc {

struct MacroOptions {
  bool actualValueMacros = true;  // FB 56 … 58: 810G/820G from software 1.7 (S5-FM-02)
  unsigned flagStackDepth = 4;    // own decision (OP-16)
  ExchangeOptions exchange{};
};

class FunctionMacros final : public sinumerik::Macros {
 public:
  using Trap = sinumerik::Trap;
  using Machine = sinumerik::Machine;

  explicit FunctionMacros(const MacroOptions& options = {});

  Control& control() { return control_; }
  const Control& control() const { return control_; }
  // The other PLC has the same area on its other side.
  void couple(std::shared_ptr<CouplingArea> area, Side side, std::function<void()> meet = {});

  bool has(std::uint16_t number) const override;
  std::optional<Trap> call(std::uint16_t number, Machine& machine,
                           std::span<const std::uint16_t> parameters) override;
  void restart(Machine& machine) override;
  void stops() override;
  void cycleBegins() override { exchange_.cycleBegins(); }
  std::optional<Trap> advance(Machine& machine, Instant now) override;
  Instant next() const override { return exchange_.next(); }
  void delay(Duration by) override { exchange_.delay(by); }
  bool masterPlcRuns() const override { return coupling_.masterRuns(); }

 private:
  struct Row;
  static std::span<const Row> rows();
  const Row* find(std::uint16_t number) const;

  MacroOptions options_;
  Control control_;
  FlagStack stack_;
  DataExchange exchange_;
  Coupling coupling_;
};

}  // namespace merker::nc
