#include "networks/alignment.h"

#include <algorithm>

namespace merker::networks {
namespace {

constexpr std::size_t kMostCells = 4'000'000;

// What lies between the first and the last difference of the two.
class Middle {
 public:
  Middle(const graph::Statements& old, const graph::Statements& now) : old_(old), now_(now) {
    const std::size_t shorter = std::min(old.size(), now.size());
    while (first_ < shorter && sameStatement(old[first_], now[first_])) ++first_;
    while (last_ < shorter - first_ &&
           sameStatement(old[old.size() - 1 - last_], now[now.size() - 1 - last_]))
      ++last_;
  }

  // The longest common subsequence; of very long differences nothing.
  void match(std::vector<std::int32_t>& same) const {
    for (std::size_t i = 0; i < first_; ++i) same[i] = static_cast<std::int32_t>(i);
    for (std::size_t i = 1; i <= last_; ++i)
      same[now_.size() - i] = static_cast<std::int32_t>(old_.size() - i);
    const std::size_t rows = old_.size() - first_ - last_, columns = now_.size() - first_ - last_;
    if (rows == 0 || columns == 0 || (rows + 1) * (columns + 1) > kMostCells) return;
    const std::vector<std::uint16_t> lengths = table(rows, columns);
    for (std::size_t row = 0, column = 0; row < rows && column < columns;) {
      const std::size_t at = row * (columns + 1) + column;
      if (equal(row, column)) {
        same[first_ + column++] = static_cast<std::int32_t>(first_ + row++);
      } else if (lengths[at + columns + 1] >= lengths[at + 1]) {
        ++row;
      } else {
        ++column;
      }
    }
  }

 private:
  bool equal(std::size_t row, std::size_t column) const {
    return sameStatement(old_[first_ + row], now_[first_ + column]);
  }

  // How much is common from a row and a column on.
  std::vector<std::uint16_t> table(std::size_t rows, std::size_t columns) const {
    const std::size_t width = columns + 1;
    std::vector<std::uint16_t> out((rows + 1) * width);
    for (std::size_t row = rows; row-- > 0;)
      for (std::size_t column = columns; column-- > 0;) {
        const std::size_t at = row * width + column;
        out[at] = equal(row, column) ? static_cast<std::uint16_t>(out[at + width + 1] + 1)
                                     : std::max(out[at + width], out[at + 1]);
      }
    return out;
  }

  const graph::Statements& old_;
  const graph::Statements& now_;
  std::size_t first_ = 0, last_ = 0;
};

// Between two statements that stay: as many old ones as new ones are replaced one by one, else
// those with the same operation from the first on.
void replace(const graph::Statements& old, std::size_t oldBegin, std::size_t oldEnd,
             const graph::Statements& now, std::size_t begin, std::size_t end, Alignment& out) {
  const bool all = oldEnd - oldBegin == end - begin;
  std::size_t at = oldBegin;
  for (std::size_t i = begin; i < end && at < oldEnd; ++i) {
    if (!all && old[at].op != now[i].op) continue;
    out.instead[i] = static_cast<std::int32_t>(at++);
  }
}

}  // namespace

bool sameStatement(const graph::Statement& a, const graph::Statement& b) {
  return a.op == b.op && a.operand == b.operand && (a.target >= 0) == (b.target >= 0) &&
         a.arguments == b.arguments;
}

Alignment align(const graph::Statements& old, const graph::Statements& now) {
  Alignment out{std::vector<std::int32_t>(now.size(), -1),
                std::vector<std::int32_t>(now.size(), -1)};
  Middle(old, now).match(out.same);
  std::size_t oldBegin = 0, begin = 0;
  for (std::size_t i = 0; i <= now.size(); ++i) {
    if (i < now.size() && out.same[i] < 0) continue;
    const std::size_t stays = i < now.size() ? static_cast<std::size_t>(out.same[i]) : old.size();
    replace(old, oldBegin, stays, now, begin, i, out);
    oldBegin = stays + 1;
    begin = i + 1;
  }
  return out;
}

}  // namespace merker::networks
