#include "s5d/comments.h"

#include <algorithm>
#include <map>

#include "s5d/bytes.h"
#include "s5d/kind.h"
#include "s5d/lines.h"
#include "source/dos_text.h"

namespace merker::s5d {
namespace {

using mc5::Block;
using mc5::BlockType;

constexpr std::size_t kCodeEntries = 26, kDataTitle = 28;
constexpr std::uint8_t kStatement = 0x80;    // in the second byte of an entry; 0: a title
constexpr std::size_t kLongestText = 0x7F;   // bytes
constexpr std::uint32_t kLastLine = 0x7FFF;  // 15 bits

bool isData(const Block& block) { return block.id.type == BlockType::Db; }

// --- reading ---

struct Entry {
  std::uint8_t low = 0, flag = 0;
  std::string text;  // with the blanks around it

  std::uint32_t line() const { return (flag & 0x7Fu) << 8 | low; }
};

std::string textAt(Bytes bytes, std::size_t at, std::size_t length, Encoding codePage) {
  std::string text;
  for (std::size_t i = 0; i < length; ++i) text += static_cast<char>(byteAt(bytes, at + i));
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return toUtf8(text, codePage);
}

// The marks of comments in listings; checks have one of their own.
std::string marked(std::string_view entry) {
  const std::string text(trim(entry));
  return text.starts_with("//=") ? text : "! " + text;
}

class Reader {
 public:
  Reader(Bytes bytes, const mc5::Program& program, Encoding codePage, Block& block)
      : bytes_(bytes), codePage_(codePage), block_(block) {
    for (const CommentLine& line : commentLines(program, block))
      lines_[{line.network, line.line}] = line.offset;
    starts_ = isData(block) ? std::vector<std::uint32_t>{} : networkStarts(program, block);
  }

  std::size_t read() {
    std::size_t at = isData(block_) ? title() : kCodeEntries;
    while (at + 3 <= bytes_.size()) {
      const std::size_t length = bytes_[at + 2] & kLongestText;
      Entry entry{bytes_[at], bytes_[at + 1], textAt(bytes_, at + 3, length, codePage_)};
      if (entry.low == 0 && entry.flag == 0 && !isData(block_)) break;  // filled up
      if (entry.flag == 0 && length == 0 && isData(block_)) break;
      at += 3 + length;
      take(std::move(entry), length == kLongestText);
    }
    flush();
    return lost_;
  }

 private:
  std::size_t title() {
    const std::size_t length = byteAt(bytes_, kDataTitle) & kLongestText;
    const std::string text = textAt(bytes_, kDataTitle + 1, length, codePage_);
    if (!trim(text).empty()) block_.comments.push_back({0, false, marked(text)});
    return kDataTitle + 1 + length;
  }

  // A text of the greatest length continues in the next entry.
  void take(Entry entry, bool full) {
    const bool isTitle = entry.flag == 0 && !isData(block_);
    if (isTitle || entry.line() != line_) flush();
    if (isTitle) return nameNetwork(entry);
    line_ = entry.line();
    if (full_ && !texts_.empty())
      texts_.back() += entry.text;
    else
      texts_.push_back(std::move(entry.text));
    full_ = full;
  }

  void nameNetwork(const Entry& entry) {
    network_ = entry.low;
    const std::string title(trim(entry.text));
    if (title.empty()) return;
    if (network_ == 0 || network_ > starts_.size()) {
      ++lost_;
      return;
    }
    auto& networks = block_.networks;                                       // their offsets ascend
    if (networks.empty()) networks.push_back({starts_[network_ - 1], ""});  // the only one
    const auto found =
        std::ranges::lower_bound(networks, starts_[network_ - 1], {}, &mc5::Network::offset);
    if (found != networks.end() && found->offset == starts_[network_ - 1]) found->title = title;
  }

  // Of several comments of one line all but the last stood in lines of their own before it.
  void flush() {
    const auto found = lines_.find({isData(block_) ? 0 : network_, line_});
    if (found == lines_.end()) {
      lost_ += texts_.size();
    } else {
      for (std::size_t i = 0; i < texts_.size(); ++i)
        if (!trim(texts_[i]).empty())
          block_.comments.push_back({found->second, i + 1 == texts_.size(), marked(texts_[i])});
    }
    texts_.clear();
    full_ = false;
  }

  Bytes bytes_;
  Encoding codePage_;
  Block& block_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> lines_;  // network, line
  std::vector<std::uint32_t> starts_;
  std::uint32_t network_ = 1, line_ = 0;
  std::vector<std::string> texts_;  // of line_
  bool full_ = false;               // the last one may continue
  std::size_t lost_ = 0;
};

// --- writing ---

std::string unmarked(const std::string& text) {
  if (text.starts_with("//=")) return text;
  return text.substr(std::min(text.find_first_not_of("!;/ \t"), text.size()));
}

class Writer {
 public:
  Writer(const mc5::Program& program, const Block& block, Encoding codePage)
      : program_(program), block_(block), codePage_(codePage) {}

  std::vector<std::uint8_t> write() {
    out_.assign(isData(block_) ? kDataTitle + 1 : kCodeEntries, 0);
    const std::vector<CommentLine> lines = commentLines(program_, block_);
    if (!isData(block_)) starts_ = networkStarts(program_, block_);
    sortIn(lines);
    std::uint32_t network = 0;
    for (const CommentLine& line : lines) {
      if (line.network != network) title(network = line.network);
      entries(line);
    }
    if (!said_) return {};
    if (out_.size() % 2 != 0) out_.push_back(0);
    putHead(out_, *kindOf(block_.id.type, Group::Comments), block_.id.number, block_.library);
    return std::move(out_);
  }

 private:
  // Each comment to the first line at or behind its word; those behind the last line to that one.
  void sortIn(const std::vector<CommentLine>& lines) {
    for (const std::string& text : block_.heading) add(lines, {0, false, text});
    for (const mc5::Comment& comment : block_.comments) add(lines, comment);
  }

  void add(const std::vector<CommentLine>& lines, const mc5::Comment& comment) {
    if (lines.empty()) return;
    auto at = std::ranges::lower_bound(lines, comment.offset, {}, &CommentLine::offset);
    if (at == lines.end()) at = std::prev(lines.end());
    // NAME and the first parameter have the same word: what stands behind is of the parameter.
    if (comment.behind && std::next(at) != lines.end() && std::next(at)->offset == at->offset) ++at;
    auto& of = texts_[at->network << 16 | at->line];
    (comment.behind && of.behind.empty() ? of.behind : of.before.emplace_back()) =
        unmarked(comment.text);
  }

  void title(std::uint32_t number) {
    if (number == 0 || number > 255) return;
    std::string text;
    for (const mc5::Network& network : block_.networks)
      if (network.offset == starts_[number - 1]) text = network.title;
    said_ |= !text.empty();
    put(static_cast<std::uint8_t>(number), 0, text);
  }

  void entries(const CommentLine& line) {
    const auto found = texts_.find(line.network << 16 | line.line);
    if (found == texts_.end() || line.line > kLastLine || line.network > 255) return;
    for (const std::string& text : found->second.before) comment(line, text);
    comment(line, found->second.behind);
    said_ = true;
  }

  // A text that is too long continues in the next entry of its line; none may seem to.
  void comment(const CommentLine& line, const std::string& text) {
    const std::string bytes = source::toDos(text, codePage_);
    const auto flag = static_cast<std::uint8_t>(kStatement | line.line >> 8);
    for (std::size_t at = 0; at == 0 || at < bytes.size(); at += kLongestText)
      putBytes(static_cast<std::uint8_t>(line.line), flag, bytes.substr(at, kLongestText));
    if (!bytes.empty() && bytes.size() % kLongestText == 0)
      putBytes(static_cast<std::uint8_t>(line.line), flag, "");
  }

  void put(std::uint8_t low, std::uint8_t flag, const std::string& text) {
    putBytes(low, flag, source::toDos(text, codePage_).substr(0, kLongestText));
  }

  void putBytes(std::uint8_t low, std::uint8_t flag, const std::string& bytes) {
    out_.insert(out_.end(), {low, flag, static_cast<std::uint8_t>(bytes.size())});
    out_.insert(out_.end(), bytes.begin(), bytes.end());
  }

  struct Texts {
    std::vector<std::string> before;
    std::string behind;
  };

  const mc5::Program& program_;
  const Block& block_;
  Encoding codePage_;
  std::vector<std::uint8_t> out_;
  std::map<std::uint32_t, Texts> texts_;  // network and line
  std::vector<std::uint32_t> starts_;     // of networks
  bool said_ = false;                     // there is a text
};

}  // namespace

std::size_t readComments(Bytes comments, const mc5::Program& program, Encoding codePage,
                         mc5::Block& block) {
  return Reader(comments, program, codePage, block).read();
}

std::vector<std::uint8_t> writeComments(const mc5::Program& program, const mc5::Block& block,
                                        Encoding codePage) {
  return Writer(program, block, codePage).write();
}

}  // namespace merker::s5d
