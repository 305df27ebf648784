#include "network/workers.h"

#include <algorithm>

namespace merker::network {

Workers::Workers(unsigned threads) : size_(std::max(1u, threads)) {
  if (size_ == 1) return;
  begin_.emplace(static_cast<std::ptrdiff_t>(size_));
  end_.emplace(static_cast<std::ptrdiff_t>(size_));
  for (std::size_t number = 1; number < size_; ++number)
    threads_.emplace_back([this, number] {
      for (;;) {
        begin_->arrive_and_wait();
        if (work_ == nullptr) return;
        share(number);
        end_->arrive_and_wait();
      }
    });
}

Workers::~Workers() {
  if (size_ == 1) return;
  work_ = nullptr;
  begin_->arrive_and_wait();
}

void Workers::share(std::size_t first) const {
  for (std::size_t i = first; i < count_; i += size_) (*work_)(i);
}

void Workers::each(std::size_t count, const std::function<void(std::size_t)>& work) {
  count_ = count;
  work_ = &work;
  if (size_ == 1) return share(0);
  begin_->arrive_and_wait();
  share(0);
  end_->arrive_and_wait();
}

}  // namespace merker::network
