#include "system/text.h"

#include <algorithm>

namespace merker::system {

std::string getText(Arguments& a, std::size_t i) {
  const Region head = a.composite(i, 2, cpu::Access::Read);
  if (!head) return {};
  const std::uint32_t longest = head.data[0], length = head.data[1];
  if (longest > 254 || length > longest) {
    a.fail();
    return {};
  }
  const Region all = a.composite(i, length + 2, cpu::Access::Read);
  return all ? std::string(all.data + 2, all.data + 2 + length) : std::string();
}

void setText(Arguments& a, std::size_t i, const std::string& text) {
  const Region head = a.composite(i, 2, cpu::Access::Write);
  if (!head) return;
  const std::size_t length = std::min<std::size_t>(head.data[0], text.size());
  if (length < text.size()) a.fail();
  const Region all = a.composite(i, static_cast<std::uint32_t>(length) + 2, cpu::Access::Write);
  if (!all) return;
  all.data[1] = static_cast<std::uint8_t>(length);
  std::copy_n(text.begin(), length, all.data + 2);
}

void setWholeText(Arguments& a, std::size_t i, const std::string& text) {
  const Region head = a.composite(i, 2, cpu::Access::Write);
  if (head && text.size() > head.data[0]) return a.fail();
  setText(a, i, text);
}

}  // namespace merker::system
