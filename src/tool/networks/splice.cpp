#include "networks/splice.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "networks/alignment.h"

namespace merker::networks {
namespace {

using graph::Written;

// Statements that share lines.
struct Chunk {
  std::size_t first = 0, last = 0;  // statements [first, last)
  std::uint32_t line = 1, end = 1;  // lines [line, end)
  bool kept = false;                // all its statements stay, one behind the other
  std::int64_t carrier = -1;        // the statement that takes the comment behind the last one
};

std::vector<Chunk> chunksOf(const std::vector<Written>& places) {
  std::vector<Chunk> out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (out.empty() || places[i].line >= out.back().end)
      out.push_back({i, i, places[i].line, places[i].end});
    out.back().last = i + 1;
    out.back().end = std::max(out.back().end, places[i].end);
  }
  return out;
}

class Splicer {
 public:
  explicit Splicer(Splice splice)
      : s_(std::move(splice)),
        places_(s_.network.places),
        alignment_(align(s_.network.statements, s_.now)),
        chunks_(chunksOf(places_)),
        chunkOf_(places_.size()),
        boxLabel_(places_.size()),
        label_(s_.now.size()),
        target_(s_.now.size()),
        changed_(s_.now.size()) {
    for (std::size_t c = 0; c < chunks_.size(); ++c)
      for (std::size_t i = chunks_[c].first; i < chunks_[c].last; ++i) chunkOf_[i] = c;
  }

  TextEdit splice() {
    nameTargets();
    moveFirstLabel();
    keepChunks();
    write();
    return trimmed();
  }

 private:
  std::int64_t same(std::size_t now) const { return alignment_.same[now]; }

  // Labels inside the network, where SPBNB of boxes lead.
  void nameTargets() {
    const graph::Statements& old = s_.network.statements;
    for (const graph::Statement& statement : old)
      if (statement.target >= 0) boxLabel_[static_cast<std::size_t>(statement.target)] = true;
    for (std::size_t i = 0; i < s_.now.size(); ++i) {
      if (s_.now[i].target < 0) continue;
      const auto target = static_cast<std::size_t>(s_.now[i].target);
      const std::int64_t jump = same(i);
      const graph::Statement* before = jump >= 0 ? &old[static_cast<std::size_t>(jump)] : nullptr;
      label_[target] = labelOf(target, before);
      target_[i] = label_[target];
      const bool stays = before != nullptr && same(target) >= 0 && before->target == same(target) &&
                         before->operand.text == target_[i];
      if (!stays) changed_[i] = changed_[target] = true;
    }
    if (places_.empty() && !s_.now.empty() && label_[0].empty()) label_[0] = s_.network.label;
    for (std::size_t i = 0; i < s_.now.size(); ++i) {
      const std::int64_t origin = alignment_.origin(i);
      if (origin < 0) continue;
      const auto from = static_cast<std::size_t>(origin);
      if (!boxLabel_[from] && label_[i].empty()) label_[i] = places_[from].label;
      if (label_[i] != places_[from].label) changed_[i] = true;
    }
  }

  // The box of a jump that stays keeps its label, also where its last statement is another one.
  std::string labelOf(std::size_t target, const graph::Statement* before) {
    if (!label_[target].empty()) return label_[target];
    const bool keeps = before != nullptr &&
                       labelled_.try_emplace(before->operand.text, target).first->second == target;
    return keeps ? before->operand.text : newLabel();
  }

  std::string newLabel() {
    for (int number = 1;; ++number)
      if (std::string name = fmt::format("_{:03}", number); s_.labels.insert(name).second)
        return name;
  }

  // Jumps of other networks lead to the first statement, whichever that is.
  void moveFirstLabel() {
    if (places_.empty() || places_.front().label.empty() || boxLabel_.front()) return;
    for (std::size_t i = 0; i < s_.now.size(); ++i) {
      const bool first = i == 0;
      if (first == (alignment_.origin(i) == 0)) continue;
      label_[i] = first ? places_.front().label : std::string();
      changed_[i] = true;
    }
  }

  void keepChunks() {
    std::vector<std::int64_t> stays(places_.size(), -1);  // by old statement
    for (std::size_t i = 0; i < s_.now.size(); ++i) {
      const std::int64_t old = alignment_.origin(i);
      if (old < 0) continue;
      Chunk& chunk = chunks_[chunkOf_[static_cast<std::size_t>(old)]];
      chunk.carrier = old;
      if (same(i) >= 0 && !changed_[i])
        stays[static_cast<std::size_t>(old)] = static_cast<std::int64_t>(i);
    }
    for (Chunk& chunk : chunks_) {
      chunk.kept = true;
      for (std::size_t i = chunk.first; i < chunk.last; ++i)
        chunk.kept = chunk.kept && stays[i] >= 0 &&
                     stays[i] - stays[chunk.first] == static_cast<std::int64_t>(i - chunk.first);
    }
  }

  void write() {
    std::size_t old = 0;
    for (std::size_t i = 0; i < s_.now.size(); ++i) {
      const std::int64_t origin = alignment_.origin(i);
      for (; origin >= 0 && old < static_cast<std::size_t>(origin); ++old) removed(old);
      if (origin < 0)
        statement(i, nullptr);
      else
        present(i, old++);
    }
    for (; old < places_.size(); ++old) removed(old);
    if (s_.now.empty() && !places_.empty() && !places_.front().label.empty() && !boxLabel_.front())
      lines_.push_back(places_.front().label + ":");
  }

  void present(std::size_t now, std::size_t old) {
    const Chunk& chunk = reach(old);
    if (!chunk.kept) return statement(now, &places_[old]);
    if (old == chunk.first) keep(chunk.line, chunk.end);
  }

  void removed(std::size_t old) {
    if (const Chunk& chunk = reach(old); old == chunk.first) residue(places_[old]);
  }

  // What stands between two chunks, comments and empty lines, stays.
  const Chunk& reach(std::size_t old) {
    const std::size_t chunk = chunkOf_[old];
    for (; reached_ <= chunk; ++reached_)
      if (reached_ > 0) keep(chunks_[reached_ - 1].end, chunks_[reached_].line);
    return chunks_[chunk];
  }

  void keep(std::uint32_t line, std::uint32_t end) {
    for (; line < end; ++line) lines_.emplace_back(s_.file.line(line));
  }

  std::size_t lineStart(std::uint32_t line) const {
    return static_cast<std::size_t>(s_.file.line(line).data() - s_.file.text().data());
  }
  std::string_view slice(std::size_t begin, std::size_t end) const {
    return s_.file.text().substr(begin, end - begin);
  }

  // What stands before a statement on its line and does not belong to it.
  void residue(const Written& place) {
    const std::string_view text = slice(lineStart(place.line), place.start);
    if (!trim(text).empty()) lines_.emplace_back(text);
  }

  void statement(std::size_t now, const Written* old) {
    std::string text = lead(now, old);
    const bool stays = same(now) >= 0 && (s_.now[now].target < 0 || !changed_[now]);
    text += old != nullptr && stays ? old->text : s_.write(s_.now[now], target_[now]);
    text += s_.style.end;
    if (old != nullptr) text = withComment(std::move(text), *old);
    append(text);
  }

  std::string lead(std::size_t now, const Written* old) {
    const bool begins = old != nullptr && isFirst(*old);
    if (begins && label_[now] == old->label)
      return std::string(slice(lineStart(old->line), old->begin));
    if (begins) residue(*old);
    const std::string& label = label_[now];
    if (label.empty()) return s_.style.indent;
    if (s_.style.indent.find(':') != std::string::npos) return label + " : ";
    return fmt::format("{:<{}}", label + ": ", s_.style.indent.size());
  }

  std::size_t numberOf(const Written& place) const {
    return static_cast<std::size_t>(&place - places_.data());
  }
  bool isFirst(const Written& place) const {
    return chunks_[chunkOf_[numberOf(place)]].first == numberOf(place);
  }

  // With the comment behind the last statement of its line, at its column if there is room.
  std::string withComment(std::string text, const Written& place) const {
    const std::size_t number = numberOf(place);
    const Chunk& chunk = chunks_[chunkOf_[number]];
    if (chunk.carrier != static_cast<std::int64_t>(number)) return text;
    const Written& last = places_[chunk.last - 1];
    const std::size_t begin = last.begin + last.length, start = lineStart(chunk.end - 1);
    const std::string_view line = s_.file.line(chunk.end - 1);
    if (begin < start || begin >= start + line.size()) return text;
    const std::string_view comment = trim(line.substr(begin - start));
    if (comment.empty()) return text;
    const auto column = characterCount(
        slice(start, static_cast<std::size_t>(comment.data() - s_.file.text().data())));
    const std::size_t used = characterCount(text.substr(text.rfind('\n') + 1));
    text.append(used < column ? column - used : 1, ' ');
    return text.append(comment);
  }

  void append(const std::string& text) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string line = text.substr(begin, end - begin);
      if (line.ends_with('\r')) line.pop_back();
      lines_.push_back(std::move(line));
      begin = end + 1;
    }
  }

  // Of a network that is empty, but for a label.
  std::uint32_t firstLine() const {
    return s_.network.labelLine > 0 ? s_.network.labelLine : s_.network.code;
  }

  // Without the lines that are the same before and behind.
  TextEdit trimmed() {
    TextEdit out;
    out.from = chunks_.empty() ? firstLine() : chunks_.front().line;
    out.to = chunks_.empty() ? out.from : chunks_.back().end;
    if (chunks_.empty() && s_.network.labelLine > 0) ++out.to;
    std::size_t first = 0, last = lines_.size();
    for (; first < last && out.from < out.to && s_.file.line(out.from) == lines_[first]; ++first)
      ++out.from;
    for (; first < last && out.from < out.to && s_.file.line(out.to - 1) == lines_[last - 1];
         --last)
      --out.to;
    out.lines.assign(lines_.begin() + static_cast<std::ptrdiff_t>(first),
                     lines_.begin() + static_cast<std::ptrdiff_t>(last));
    return out;
  }

  Splice s_;
  const std::vector<Written>& places_;
  Alignment alignment_;
  std::vector<Chunk> chunks_;
  std::vector<std::size_t> chunkOf_;             // by old statement
  std::map<std::string, std::size_t> labelled_;  // new statements by the labels that stay
  std::vector<bool> boxLabel_;                   // by old statement: a box jumps to it
  std::vector<std::string> label_;               // by new statement: in front of it
  std::vector<std::string> target_;              // by new statement: where it jumps to
  std::vector<bool> changed_;                    // by new statement: label or target differ
  std::size_t reached_ = 0;                      // chunks
  std::vector<std::string> lines_;
};

}  // namespace

TextEdit spliced(Splice splice) { return Splicer(std::move(splice)).splice(); }

}  // namespace merker::networks
