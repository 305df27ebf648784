// A fast input of a channel: the level at its terminal, or a signal that is known in advance, and
// the filter behind it. A level passes when it has lasted for the filter time (CNT-PARAM-10).
#pragma once

#include <memory>

#include "signal/signal.h"

namespace merker::technology {

class Input {
 public:
  explicit Input(Duration filter = {}) : filter_(filter) {}

  // From now on this lies at the terminal; `signal` null: the level stays.
  void set(bool level, std::shared_ptr<const signal::Signal> signal, Instant now);
  bool passed() const { return passed_; }
  bool settled() const { return raw_ == passed_; }

  Instant change() const { return change_; }  // of the signal, the next one
  Instant due() const { return settled() ? Instant::never() : since_ + filter_; }
  Instant next() const;
  void takeChange();  // change() has come
  void pass() { passed_ = raw_; }
  void setFilter(Duration filter) { filter_ = filter; }
  void jump() { passed_ = raw_; }  // without waiting: the CPU starts

  const signal::Signal* signal() const { return signal_.get(); }
  bool raw() const { return raw_; }
  Instant since() const { return since_; }  // the terminal changed last
  Duration filter() const { return filter_; }
  // Whole periods later; the signal's rhythm holds so long.
  void skip(std::int64_t periods);

 private:
  Duration filter_;
  std::shared_ptr<const signal::Signal> signal_;
  bool raw_ = false, passed_ = false;
  Instant since_ = signal::kLongAgo, change_ = Instant::never();
};

}  // namespace merker::technology
