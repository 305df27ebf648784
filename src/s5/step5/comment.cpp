#include "step5/comment.h"

#include "base/text.h"

namespace merker::step5 {

std::string commentText(std::string_view rest) {
  const std::string_view text = trim(rest);
  const bool marked = text.starts_with('!') || text.starts_with(';') || text.starts_with("//");
  const std::size_t words = text.find_first_not_of("!;/* \t");
  if (words == std::string_view::npos) return {};
  return marked ? std::string(text) : "! " + std::string(text);
}

void keepComment(mc5::Block& block, std::uint32_t word, bool behind, std::string_view rest) {
  std::string text = commentText(rest);
  if (!text.empty()) block.comments.push_back({word, behind, std::move(text)});
}

}  // namespace merker::step5
