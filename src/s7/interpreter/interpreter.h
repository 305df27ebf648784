// The reference engine: runs MC7 blocks instruction by instruction, plain and obviously right.
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "cpu/engine.h"
#include "interpreter/recorder.h"

namespace merker::interpreter {

class Interpreter : public cpu::Engine {
 public:
  explicit Interpreter(const CpuModel& model) : translator_(table_, model) {}
  // From the next translation on, count how often each instruction runs.
  void countCoverage(bool on) { coverage_ = on; }

  std::unique_ptr<cpu::Code> translate(const block::Block& block) override;
  void run(cpu::Machine& machine) override;
  void probe(cpu::Code& code, cpu::Probe* probe) override;
  std::uint32_t offset(const cpu::Frame& frame) const override;
  bool watched() const override { return probes_ > 0 || keepsOldCode(); }
  bool keepsOldCode() const override { return coverage_ || !recorder_.records().empty(); }

  // How often each counted instruction ran, by block and offset.
  std::map<BlockId, std::map<std::uint32_t, std::uint64_t>> executed() const;
  const std::deque<block::CheckRecord>& checkRecords() const { return recorder_.records(); }

 private:
  void attachSide(const block::Block& block, Translated& code, const OpByWord& opAt);

  HandlerTable table_;
  Translator translator_;
  Recorder recorder_;
  bool coverage_ = false;
  int probes_ = 0;                          // that look at blocks
  std::vector<const Translated*> counted_;  // they belong to the CPU, which loads once
};

}  // namespace merker::interpreter
