// Edits of a text as what they do, and why there is none.
#include "networks/source_edit.h"

namespace merker::networks {
namespace {

struct Row {
  Obstacle obstacle;
  std::string_view english, german;
};
constexpr Row kTexts[] = {
    {Obstacle::NoNetwork, "the network was not found", "das Netzwerk wurde nicht gefunden"},
    {Obstacle::Awl, "the network can only be changed as AWL",
     "das Netzwerk kann nur als AWL geändert werden"},
    {Obstacle::Text, "the text must be one operand", "der Text muss ein Operand sein"},
    {Obstacle::Label,
     "a label must be a letter and at most three more letters or digits, once in the block, "
     "before a statement",
     "eine Marke muss ein Buchstabe und höchstens drei weitere Buchstaben oder Ziffern sein, "
     "einmal im "
     "Baustein, vor einer Anweisung"},
    {Obstacle::Clipboard, "what is pasted must be statements that can be drawn, or whole networks",
     "was eingefügt wird, muss aus Anweisungen, die dargestellt werden können, oder aus ganzen "
     "Netzwerken bestehen"}};

}  // namespace

std::string_view text(const Refusal& refusal, graph::Language language) {
  const bool german = language == graph::Language::German;
  for (const Row& row : kTexts)
    if (row.obstacle == refusal.obstacle) return german ? row.german : row.english;
  return graph::text(refusal.problem, language);
}

std::string applied(const source::SourceFile& file, const TextEdit& edit) {
  const std::string_view whole = file.text();
  const auto start = [&](std::uint32_t line) {
    return line > file.lineCount()
               ? whole.size()
               : static_cast<std::size_t>(file.line(line).data() - whole.data());
  };
  std::string out(whole.substr(0, start(edit.from)));
  if (!edit.lines.empty() && !out.empty() && out.back() != '\n') out += '\n';
  for (const std::string& line : edit.lines) out += line + '\n';
  return out.append(whole.substr(start(edit.to)));
}

}  // namespace merker::networks
