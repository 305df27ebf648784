// Goes through the statements of a network, and back where an attempt fails. The refusal of the
// attempt that came furthest is the one to tell.
#pragma once

#include <span>

#include "graph/reason.h"
#include "graph/statement.h"

namespace merker::graph {

class Cursor {
 public:
  explicit Cursor(std::span<const Statement> statements) : statements_(statements) {}

  std::size_t at() const { return at_; }
  bool atEnd() const { return at_ >= statements_.size(); }
  // OTHER behind the end.
  Op op(std::size_t ahead = 0) const {
    return at_ + ahead < statements_.size() ? statements_[at_ + ahead].op : Op::OTHER;
  }
  bool is(Op op, std::size_t ahead = 0) const { return !past(ahead) && this->op(ahead) == op; }
  bool isBld(std::uint32_t number, std::size_t ahead = 0) const {
    return is(Op::BLD, ahead) && look(ahead).operand.number == number;
  }
  bool has(std::size_t ahead) const { return !past(ahead); }
  const Statement& look(std::size_t ahead = 0) const { return statements_[at_ + ahead]; }
  const Statement& take() {
    ++steps_;
    return statements_[at_++];
  }
  bool takeIf(Op op) {
    if (!is(op)) return false;
    take();
    return true;
  }
  void back(std::size_t at) { at_ = at; }

  // Attempts are bounded: brackets inside boxes inside brackets must not take forever.
  bool exhausted() const { return steps_ > 2000 + statements_.size() * 200; }

  // Notes why it does not go on here; always false.
  bool refuse(Reason reason) { return refuse(reason, at_); }
  bool refuse(Reason reason, std::size_t statement) {
    if (!refused_ || statement > refusal_.statement) refusal_ = {statement, reason};
    refused_ = true;
    return false;
  }
  const Refusal& refusal() const { return refusal_; }
  void forget() { refused_ = false; }

 private:
  bool past(std::size_t ahead) const { return at_ + ahead >= statements_.size(); }

  std::span<const Statement> statements_;
  std::size_t at_ = 0, steps_ = 0;
  Refusal refusal_;
  bool refused_ = false;
};

}  // namespace merker::graph
