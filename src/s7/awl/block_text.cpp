#include "awl/block_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "awl/declaration_text.h"

namespace merker::awl {
namespace {

struct Frame {
  BlockKind kind;
  std::string_view begin, end;
};
constexpr Frame kFrames[] = {{BlockKind::OB, "ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK"},
                             {BlockKind::FC, "FUNCTION", "END_FUNCTION"},
                             {BlockKind::SFC, "FUNCTION", "END_FUNCTION"},
                             {BlockKind::FB, "FUNCTION_BLOCK", "END_FUNCTION_BLOCK"},
                             {BlockKind::SFB, "FUNCTION_BLOCK", "END_FUNCTION_BLOCK"},
                             {BlockKind::DB, "DATA_BLOCK", "END_DATA_BLOCK"},
                             {BlockKind::UDT, "TYPE", "END_TYPE"}};

const Frame& frameOf(BlockKind kind) {
  return *std::find_if(std::begin(kFrames), std::end(kFrames),
                       [kind](const Frame& frame) { return frame.kind == kind; });
}

std::string oneLine(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c == '\n' || c == '\r') c = ' ';
  return out;
}

bool isPlain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || c == '_' || byte >= 0x80;
}

// AUTHOR and the like take a word of up to eight characters. What ends such a word, even between
// quotation marks, becomes '_'.
void attribute(std::string_view key, std::string value, std::string& out) {
  if (value.empty()) return;
  for (char& c : value)
    if (static_cast<unsigned char>(c) < 0x20 ||
        std::string_view("\x7F;'\"/").find(c) != std::string_view::npos)
      c = '_';
  const bool plain = std::all_of(value.begin(), value.end(), isPlain);
  out += plain ? fmt::format("{} : {}\n", key, value) : fmt::format("{} : '{}'\n", key, value);
}

// The statements of a network with their comments. `line_` counts as the editor does: comments on
// lines of their own are not counted.
class NetworkWriter {
 public:
  NetworkWriter(const std::vector<Comment>& comments, std::string& out)
      : comments_(comments), out_(out) {}

  void statement(const Statement& statement) {
    const std::size_t count = statement.lines.size();
    for (std::size_t i = 0; i < count; ++i) {
      const bool open = i + 1 < count;  // the lines of a CALL are one statement
      const std::string label = i == 0 && !statement.label.empty() ? statement.label + ":" : "";
      std::string line = fmt::format("{:<5} {}{}{}", label, i > 0 ? "  " : "", statement.lines[i],
                                     open ? "" : ";");
      const bool counted = i < statement.editorLines;
      if (counted) ownLines(), ++line_;
      const std::string comment = counted ? behind() : std::string();
      out_ += comment.empty() ? line + "\n" : fmt::format("{:<40}//{}\n", line, comment);
    }
    if (statement.editorLines > count)
      line_ += static_cast<std::uint32_t>(statement.editorLines - count);
  }

  void rest() {
    for (; next_ < comments_.size(); ++next_) out_ += commentLines(comments_[next_].text);
  }

 private:
  void ownLines() {
    while (due(true)) out_ += commentLines(comments_[next_++].text);
  }

  std::string behind() {
    std::string comment;
    while (due(false)) comment += (comment.empty() ? "" : " ") + oneLine(comments_[next_++].text);
    return comment;
  }

  bool due(bool ownLine) const {
    return next_ < comments_.size() && comments_[next_].ownLine == ownLine &&
           comments_[next_].line <= line_;
  }

  const std::vector<Comment>& comments_;
  std::string& out_;
  std::size_t next_ = 0;
  std::uint32_t line_ = 0;  // lines written
};

std::vector<std::uint32_t> networkStarts(const block::Block& block) {
  std::vector<std::uint32_t> starts;
  for (const block::Network& network : block.networks) starts.push_back(network.offset);
  if (starts.empty()) starts.push_back(0);
  return starts;
}

}  // namespace

std::string_view endWord(BlockKind kind) { return frameOf(kind).end; }

std::string commentLines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    out += fmt::format("//{}\n", oneLine(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string headText(const block::Block& block, const Texts& texts) {
  const block::Attributes& a = block.attributes;
  std::string out;
  for (const std::string& remark : texts.remarks) out += fmt::format("// {}\n", oneLine(remark));
  out += fmt::format("{} {}", frameOf(block.id.kind).begin, toString(block.id));
  if (block.id.kind == BlockKind::FC || block.id.kind == BlockKind::SFC)
    out += " : " + texts.returnType;
  out += "\n";
  if (!a.title.empty() || !a.comment.empty())
    out += fmt::format("TITLE = {}\n", a.title.empty() ? "-" : oneLine(a.title));
  out += commentLines(a.comment);
  attribute("AUTHOR", a.author, out);
  attribute("FAMILY", a.family, out);
  attribute("NAME", a.name, out);
  if (block.id.kind != BlockKind::UDT)
    out += fmt::format("VERSION : {}.{}\n", a.version >> 4, a.version & 15);
  if (a.codeVersion1) out += "CODE_VERSION1\n";
  if (a.knowHowProtect) out += "KNOW_HOW_PROTECT\n";
  if (a.unlinked && block.id.kind == BlockKind::DB) out += "UNLINKED\n";
  if (a.nonRetain && block.id.kind == BlockKind::DB) out += "NON_RETAIN\n";
  out += "\n";
  out += !texts.dataType.empty()      ? texts.dataType + "\n"
         : !texts.declaration.empty() ? texts.declaration
                                      : declarationText(block);
  if (!out.ends_with('\n')) out += '\n';
  return out;
}

std::string codeText(const block::Block& block, const block::Block& declared, const Texts& texts,
                     const Blocks& blocks, Form form) {
  const Names names(declared);
  std::string out = headText(block, texts) + "BEGIN\n";
  if (form == Form::NetworksOfKop) out += "//# KOP\n";
  if (form == Form::NetworksOfFup) out += "//# FUP\n";
  const bool calls = form != Form::Instructions;
  const std::vector<Statement> list = statements(block, names, blocks, calls);
  const std::vector<std::uint32_t> starts = networkStarts(block);
  static const NetworkText kNoTexts;
  auto next = list.begin();
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const NetworkText& text = i < texts.networks.size() ? texts.networks[i] : kNoTexts;
    out += fmt::format("NETWORK\nTITLE = {}\n", oneLine(text.title));
    out += commentLines(text.comment);
    NetworkWriter writer(text.comments, out);
    const bool last = i + 1 == starts.size();
    for (; next != list.end() && (last || next->offset < starts[i + 1]); ++next)
      writer.statement(*next);
    writer.rest();
  }
  return fmt::format("{}{}\n", out, endWord(block.id.kind));
}

}  // namespace merker::awl
