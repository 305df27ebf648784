#include "importing/retranslation.h"

#include <algorithm>

#include "awl/data_text.h"
#include "base/text.h"
#include "block/container.h"
#include "step7/block_source.h"

namespace merker::importing {
namespace {

using s7p::StoredBlock;

bool holdsCode(BlockKind kind) { return kind != BlockKind::DB && kind != BlockKind::UDT; }

bool sameBytes(const block::Block& compiled, const block::Block& stored) {
  return holdsCode(stored.id.kind) ? compiled.code == stored.code
                                   : compiled.actualData == stored.actualData;
}

// Code may be the same with other parameters, which callers would see. A block whose interface
// could not be read has none to compare.
bool fitsInterface(const block::Block& compiled, const block::Block& stored) {
  return !holdsCode(stored.id.kind) || stored.variables.empty() || sameInterface(compiled, stored);
}

// From the beginning of the line with its first word to the end of the line with its last one.
std::string cut(const source::SourceFile& file, const step7::BlockSource& block,
                std::string_view end) {
  const std::string_view text = file.text();
  std::size_t first = text.rfind('\n', block.name.begin);
  first = first == std::string_view::npos ? 0 : first + 1;
  std::size_t last = text.find(end, block.codeEnd);
  if (last == std::string_view::npos) last = block.codeEnd;
  last = std::min(text.find('\n', last), text.size());
  return std::string(text.substr(first, last - first)) + "\n";
}

// "FC 96" of a call with a list of parameters that no CALL shows: AWL has no statement for it.
std::string calleeOfList(std::string_view text) {
  constexpr std::string_view kCall = "UC    ", kList = "\n        SPA   ";
  const std::size_t list = text.find(kList);
  if (list == std::string_view::npos) return {};
  const std::size_t call = text.rfind(kCall, list);
  if (call == std::string_view::npos) return {};
  return std::string(trim(text.substr(call + kCall.size(), list - call - kCall.size())));
}

// Most readable first; one that keeps the language of the block comes before one that loses it.
std::vector<awl::Form> formsOf(block::Language language) {
  std::vector<awl::Form> forms;
  if (language == block::Language::Kop) forms.push_back(awl::Form::NetworksOfKop);
  if (language == block::Language::Fup) forms.push_back(awl::Form::NetworksOfFup);
  forms.insert(forms.end(), {awl::Form::Calls, awl::Form::Instructions});
  return forms;
}

}  // namespace

Retranslation::Retranslation(const Material& material, const step7::CompileOptions& options,
                             Report& report)
    : material_(material),
      options_(options),
      report_(report),
      declarations_(material.blocks, options, report) {
  options_.library = &declarations_.callable();
}

const StoredBlock* Retranslation::stored(BlockId id) const {
  const auto at = std::find_if(material_.blocks.begin(), material_.blocks.end(),
                               [id](const StoredBlock& b) { return b.block.id == id; });
  return at == material_.blocks.end() ? nullptr : &*at;
}

step7::Compilation Retranslation::compile(const std::string& name, const std::string& text) const {
  return step7::compile({source::SourceFile(name, text)}, options_);
}

bool Retranslation::offer(const TextFile& source) {
  const source::SourceFile file(source.name, source.text);
  const step7::Compilation compilation = step7::compile({file}, options_);
  Problems ignored;
  bool used = false;
  for (const step7::BlockSource& block :
       step7::BlockSplitter(file, options_.symbols, ignored).split()) {
    const auto compiled = compilation.program.find(block.id);
    const StoredBlock* wanted = stored(block.id);
    if (compiled == compilation.program.end() || wanted == nullptr || kept_.contains(block.id) ||
        wanted->block.attributes.knowHowProtect || wanted->block.id.kind == BlockKind::UDT ||
        !sameBytes(compiled->second, wanted->block) ||
        !fitsInterface(compiled->second, wanted->block))
      continue;
    std::string text = cut(file, block, awl::endWord(block.id.kind));
    std::string why;
    if (!compilesTo(*wanted, text, why)) continue;
    kept_.emplace(block.id, std::move(text));
    used = true;
  }
  return used;
}

bool Retranslation::compilesTo(const StoredBlock& stored, const std::string& text,
                               std::string& why) const {
  const step7::Compilation compilation = compile(toString(stored.block.id), text);
  const auto compiled = compilation.program.find(stored.block.id);
  if (compiled != compilation.program.end() && compilation.ok() &&
      sameBytes(compiled->second, stored.block))
    return true;
  why = holdsCode(stored.block.id.kind) ? "the machine code differs" : "the values differ";
  for (const Problem& problem : compilation.problems.list())
    if (problem.severity() == Severity::Error) {
      why = fmt::format("line {}: {}", problem.position.line, problem.message);
      break;
    }
  return false;
}

std::string Retranslation::codeText(const StoredBlock& stored, const block::Block& declared,
                                    awl::Form form) const {
  const awl::Blocks blocks = [this](BlockId id) -> const block::Block* {
    const auto at = declarations_.callable().find(id);
    return at == declarations_.callable().end() ? nullptr : &at->second;
  };
  return awl::codeText(stored.block, declared, declarations_.texts(stored.block.id), blocks, form);
}

// The machine code is in a file beside it; the statements are there to be read.
std::string Retranslation::declarationOf(const StoredBlock& stored, bool hidden) const {
  const BlockId id = stored.block.id;
  const block::Block* declared = declarations_.find(id);
  if (declared == nullptr) return {};
  std::string text =
      fmt::format("// The machine code of this block is in {}{}.mc7.\n{}BEGIN\n", name(id.kind),
                  id.number, awl::headText(stored.block, declarations_.texts(id)));
  if (!hidden && holdsCode(id.kind)) {
    constexpr std::string_view kBegin = "\nBEGIN\n";
    const std::string code = codeText(stored, *declared, awl::Form::Calls);
    text += awl::commentLines(std::string_view(code).substr(code.find(kBegin) + kBegin.size()));
  }
  return fmt::format("{}{}\n", text, awl::endWord(id.kind));
}

std::string Retranslation::code(const StoredBlock& stored, std::string& why) {
  const block::Block* declared = declarations_.find(stored.block.id);
  if (declared == nullptr) {
    why = isSystemFunction(stored.block.id) ? "a system function of another CPU" : "no declaration";
    return {};
  }
  for (const awl::Form form : formsOf(stored.block.language)) {
    std::string text = codeText(stored, *declared, form);
    std::string reason;
    if (compilesTo(stored, text, reason)) return text;
    const std::string callee = form == awl::Form::Calls ? calleeOfList(text) : std::string();
    if (!callee.empty())
      reason = fmt::format("it calls {}, whose parameters are not known or are others", callee);
    if (why.empty()) why = reason;
  }
  return {};
}

std::string Retranslation::data(const StoredBlock& stored) {
  const block::Block* declared = declarations_.find(stored.block.id);
  if (declared == nullptr) return {};
  return fmt::format("{}BEGIN\n{}{}\n",
                     awl::headText(stored.block, declarations_.texts(stored.block.id)),
                     awl::assignments(*declared, stored.block.actualData).text, "END_DATA_BLOCK");
}

BlockFile Retranslation::write(const StoredBlock& stored) {
  const BlockId id = stored.block.id;
  BlockFile file{id, {}, {}, Origin::Disassembled};
  if (id.kind == BlockKind::UDT) {
    if (declarations_.find(id) == nullptr) {
      report_.add(Note::NoType, toString(id));
      return file;
    }
    file.text = awl::headText(stored.block, declarations_.texts(id)) + "END_TYPE\n";
    return file;
  }
  if (const auto kept = kept_.find(id); kept != kept_.end()) {
    file.text = kept->second;
    file.origin = Origin::Stored;
    return file;
  }
  std::string why;
  const bool hidden = stored.block.attributes.knowHowProtect;
  if (holdsCode(id.kind)) {
    if (!hidden) file.text = code(stored, why);
    if (!file.text.empty()) return file;
  } else {
    file.text = data(stored);
    if (!file.text.empty() && compilesTo(stored, file.text, why)) return file;
    file.text.clear();
  }
  file.origin = Origin::MachineCode;
  file.container = block::writeContainer(stored.block);
  file.text = declarationOf(stored, hidden);
  if (hidden && holdsCode(id.kind))
    report_.add(Note::ProtectedBlock, toString(id));
  else
    report_.add(Note::MachineCode, toString(id), why);
  return file;
}

}  // namespace merker::importing
