#include "importing/declarations.h"

#include <algorithm>

#include "awl/declaration_text.h"
#include "base/text.h"

namespace merker::importing {
namespace {

constexpr std::string_view kReturnValue = "RET_VAL";

std::string withoutReturns(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != '\r' && c != '\0') out += c;
  return out;
}

bool isReturnValue(std::string_view line) {
  line = trim(line);
  if (!equalsIgnoreCase(line.substr(0, kReturnValue.size()), kReturnValue)) return false;
  line = trim(line.substr(kReturnValue.size()));
  return line.starts_with(':') || line.starts_with('{');
}

// Takes the line of RET_VAL out of the text and gives its type: a source has it in its first line.
std::string takeReturnType(std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    if (isReturnValue(line)) {
      const std::size_t colon =
          line.rfind(" : ") == std::string_view::npos ? line.find(':') : line.find(" : ") + 1;
      std::string_view type = line.substr(colon + 1);
      type = trim(type.substr(0, std::min(type.find(';'), type.find(":="))));
      const std::string found(type);
      text.erase(at, end + 1 - at);
      return found;
    }
    at = end + 1;
  }
  return "VOID";
}

std::vector<awl::NetworkText> networksOf(const s7p::BlockComments& comments) {
  std::vector<awl::NetworkText> list;
  for (const s7p::NetworkComments& network : comments.networks) {
    awl::NetworkText text{network.title, network.comment, {}};
    for (const s7p::StatementComment& c : network.statements)
      text.comments.push_back({c.line, c.ownLine, c.text});
    list.push_back(std::move(text));
  }
  return list;
}

// Of the editors that show other than statements.
std::string_view languageName(block::Language language) {
  static constexpr std::pair<block::Language, std::string_view> kNames[] = {
      {block::Language::Kop, "KOP"},
      {block::Language::Fup, "FUP"},
      {block::Language::Scl, "SCL"},
      {block::Language::Graph, "GRAPH"}};
  for (const auto& [shown, name] : kNames)
    if (shown == language) return name;
  return {};
}

// Without text: names by place. The structure of a data block without interface is an array of
// bytes.
void declareByInterface(const s7p::StoredBlock& stored, awl::Texts& texts) {
  const block::Block& block = stored.block;
  texts.dataType.clear();
  texts.declaration = awl::declarationText(block);
  if (block.returnType) texts.returnType = awl::typeText(*block.returnType);
  if (block.id.kind == BlockKind::DB && block.variables.empty() && !block.actualData.empty())
    texts.declaration = fmt::format("STRUCT\n    STAT0 : ARRAY [0..{}] OF BYTE;\n  END_STRUCT;\n",
                                    block.actualData.size() - 1);
}

const block::Variable* firstLocal(const block::Block& block) {
  for (const block::Variable& v : block.variables)
    if (v.section == block::Section::Temp) return &v;
  return nullptr;
}

// Stored local data of an OB begin with its start information, however short the part is that they
// declare; a source says so with the name of the first variable (S7-FC-09).
void nameStartInformation(s7p::StoredBlock& stored) {
  block::Block& block = stored.block;
  for (block::Variable& v : block.variables)
    if (v.section == block::Section::Temp) {
      v.name = fmt::format("OB{}_{}", block.id.number, v.name);
      return;
    }
}

// Names do not move a variable. Only those of an OB can: see above.
bool sameLocalData(const block::Block& declared, const block::Block& stored) {
  if (stored.id.kind != BlockKind::OB) return true;
  const block::Variable* first = firstLocal(declared);
  const block::Variable* wanted = firstLocal(stored);
  return first == nullptr || wanted == nullptr || first->address == wanted->address;
}

std::string sourceOf(const block::Block& block, const awl::Texts& texts) {
  if (block.id.kind == BlockKind::UDT) return awl::headText(block, texts) + "END_TYPE\n";
  return fmt::format("{}BEGIN\n{}\n", awl::headText(block, texts), awl::endWord(block.id.kind));
}

std::vector<const block::Variable*> frame(const block::Block& block) {
  std::vector<const block::Variable*> list;
  for (const block::Variable& v : block.variables)
    if (v.section != block::Section::Temp) list.push_back(&v);
  return list;
}

}  // namespace

bool sameInterface(const block::Block& a, const block::Block& b) {
  const auto first = frame(a), second = frame(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const block::Variable* x, const block::Variable* y) {
                      return x->section == y->section && block::sameStructure(*x->type, *y->type);
                    });
}

bool isSystemFunction(BlockId id) { return id.kind == BlockKind::SFC || id.kind == BlockKind::SFB; }

bool isOfTheCpu(BlockId id, const block::Program& library) {
  return isSystemFunction(id) && library.contains(id);
}

Declarations::Declarations(const std::vector<s7p::StoredBlock>& blocks,
                           const step7::CompileOptions& given, Report& report)
    : library_(*given.library) {
  for (const s7p::StoredBlock& stored : blocks)
    if (!isSystemFunction(stored.block.id))
      declare(stored);
    else if (!isOfTheCpu(stored.block.id, *given.library))
      library_.insert_or_assign(stored.block.id, stored.block);  // of another CPU, as it is stored
  step7::CompileOptions options = given;
  options.library = &library_;
  compile(blocks, options);
  bool again = false;
  for (const s7p::StoredBlock& stored : blocks) {
    const auto known = texts_.find(stored.block.id);
    if (known == texts_.end() || fits(stored) || stored.block.id.kind == BlockKind::UDT) continue;
    awl::Texts& texts = known->second;
    const std::string name = toString(stored.block.id);
    if (!texts.dataType.empty())
      report.add(Note::InstanceWithoutBlock, name, texts.dataType);
    else if (!stored.declaration.empty())
      report.add(Note::NoNames, name);
    s7p::StoredBlock named = stored;
    if (named.block.id.kind == BlockKind::OB) nameStartInformation(named);
    declareByInterface(named, texts);
    again = true;
  }
  if (again) compile(blocks, options);
  for (const s7p::StoredBlock& stored : blocks)
    if (stored.block.id.kind != BlockKind::UDT && !fits(stored)) declared_.erase(stored.block.id);
  callable_ = library_;
  for (const auto& [id, block] : declared_) callable_.insert_or_assign(id, block);
}

void Declarations::declare(const s7p::StoredBlock& stored) {
  const block::Block& block = stored.block;
  awl::Texts texts;
  texts.declaration = withoutReturns(stored.declaration);
  texts.networks = networksOf(stored.comments);
  const std::string_view language = languageName(block.language);
  if (!language.empty() && block.id.kind != BlockKind::DB && block.id.kind != BlockKind::UDT)
    texts.remarks.push_back(fmt::format("STEP 7 shows this block in {}.", language));
  if (block.id.kind == BlockKind::FC || block.id.kind == BlockKind::SFC)
    if (block.returnType) texts.returnType = takeReturnType(texts.declaration);
  if (block.id.kind == BlockKind::DB && block.instanceOf >= 0)
    texts.dataType =
        fmt::format("{} {}", block.instanceOfSystemBlock ? "SFB" : "FB", block.instanceOf);
  if (trim(texts.declaration).empty() && texts.dataType.empty() && block.id.kind != BlockKind::UDT)
    declareByInterface(stored, texts);
  texts_.emplace(block.id, std::move(texts));
}

void Declarations::compile(const std::vector<s7p::StoredBlock>& blocks,
                           const step7::CompileOptions& options) {
  std::vector<source::SourceFile> sources;
  for (const s7p::StoredBlock& stored : blocks)
    if (texts_.contains(stored.block.id))
      sources.emplace_back(toString(stored.block.id),
                           sourceOf(stored.block, texts_.at(stored.block.id)));
  declared_ = step7::compile(sources, options).program;
}

bool Declarations::fits(const s7p::StoredBlock& stored) const {
  const block::Block* declared = find(stored.block.id);
  if (declared == nullptr) return false;
  if (stored.block.id.kind == BlockKind::DB)
    return declared->actualData.size() == stored.block.actualData.size();
  return sameInterface(*declared, stored.block) && sameLocalData(*declared, stored.block);
}

const block::Block* Declarations::find(BlockId id) const {
  const auto at = declared_.find(id);
  return at == declared_.end() ? nullptr : &at->second;
}

}  // namespace merker::importing
