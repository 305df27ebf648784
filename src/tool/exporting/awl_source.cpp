#include "exporting/awl_source.h"

#include <algorithm>
#include <map>

#include "base/text.h"
#include "exporting/awl_edits.h"
#include "exporting/awl_mnemonics.h"
#include "exporting/awl_operands.h"
#include "step7/cursor.h"

namespace merker::exporting {
namespace {

using step7::BlockSource;

// STEP 7 wants lines; a carriage return alone is one, too.
std::string withLineFeeds(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '\r')
      out += text[i];
    else if (i + 1 == text.size() || text[i + 1] != '\n')
      out += '\n';
  return out;
}

// Behind END_… and what follows it on its line, unless another block begins there.
std::size_t endOf(const BlockSource& block) {
  const std::string_view text = block.file->text();
  step7::Cursor cursor(text, block.codeEnd, text.size());
  cursor.word();
  cursor.accept(';');
  const std::size_t end = cursor.pos();
  if (!cursor.atLineEnd()) return end;
  cursor.skipLine();
  if (cursor.peek() == '\r') cursor.take();
  if (cursor.peek() == '\n') cursor.take();
  return cursor.pos();
}

bool replaced(const std::vector<Edit>& edits, std::size_t at) {
  return std::any_of(edits.begin(), edits.end(),
                     [at](const Edit& edit) { return edit.begin <= at && at < edit.end; });
}

std::vector<Edit> editsOf(const BlockSource& block, const source::SymbolTable& symbols,
                          const Style& style) {
  std::vector<Edit> edits;
  const Mnemonics mnemonics = style.mnemonics.value_or(block.mnemonics);
  if (style.names == Names::Absolute) edits = absoluteOperands(block, symbols, mnemonics);
  if (style.names == Names::Symbolic) edits = symbolicOperands(block, symbols);
  for (Edit& edit : translation(block, mnemonics))
    if (!replaced(edits, edit.begin)) edits.push_back(std::move(edit));
  if (style.punctuation)
    for (Edit& edit : punctuation(block)) edits.push_back(std::move(edit));
  for (Edit& edit : renamedParameters(block, symbols, style.parameters))
    edits.push_back(std::move(edit));
  return edits;
}

std::set<BlockId> usesOf(const BlockSource& block, const source::SymbolTable& symbols) {
  std::set<BlockId> uses;
  const auto note = [&](const Operand& operand) {
    const source::Symbol* symbol = operand.symbol.empty() ? nullptr : symbols.find(operand.symbol);
    const source::SymbolAddress* address = symbol != nullptr ? &symbol->address
                                           : operand.address ? &*operand.address
                                                             : nullptr;
    if (address != nullptr && address->kind == source::SymbolAddress::Kind::Block &&
        address->block != block.id)
      uses.insert(address->block);
  };
  eachOperand(block.file->text(), block.name.end, block.codeEnd, note);
  return uses;
}

std::vector<BlockSource> blocksOf(const source::SourceFile& file, const project::Project& project) {
  Problems ignored;
  auto blocks = step7::BlockSplitter(file, &project.symbols, ignored).split();
  const Mnemonics mnemonics =
      project.mnemonics ? *project.mnemonics : step7::detectMnemonics(file.text(), blocks);
  for (BlockSource& block : blocks) block.mnemonics = mnemonics;
  return blocks;
}

// Types first: nothing needs a block before them. What others use moves up from its place.
int rank(BlockKind kind) {
  constexpr int kBetween = 2;
  static constexpr std::pair<BlockKind, int> kRanks[] = {
      {BlockKind::UDT, 0}, {BlockKind::DB, 1}, {BlockKind::OB, 3}};
  for (const auto& [ranked, place] : kRanks)
    if (ranked == kind) return place;
  return kBetween;
}

class Order {
 public:
  explicit Order(std::vector<Piece>& pieces) : pieces_(pieces), seen_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i) places_.try_emplace(pieces[i].id, i);
  }

  std::vector<Piece> take() {
    std::vector<Piece> out;
    for (const auto& [id, place] : byRank()) visit(place, out);
    return out;
  }

 private:
  // Depth first without recursion: a chain of calls may be long.
  struct Open {
    std::size_t piece;
    std::set<BlockId>::const_iterator next;
  };

  std::vector<std::pair<int, std::size_t>> byRank() const {
    std::vector<std::pair<int, std::size_t>> all;
    for (std::size_t i = 0; i < pieces_.size(); ++i) all.emplace_back(rank(pieces_[i].id.kind), i);
    std::sort(all.begin(), all.end());
    return all;
  }

  void visit(std::size_t first, std::vector<Piece>& out) {
    std::vector<Open> open;
    enter(first, open);
    while (!open.empty()) {
      Open& top = open.back();
      if (top.next != pieces_[top.piece].uses.end()) {
        const auto used = places_.find(*top.next++);
        if (used != places_.end()) enter(used->second, open);
      } else {
        out.push_back(std::move(pieces_[top.piece]));
        open.pop_back();
      }
    }
  }

  void enter(std::size_t piece, std::vector<Open>& open) {
    if (seen_[piece]) return;
    seen_[piece] = true;
    open.push_back({piece, pieces_[piece].uses.begin()});
  }

  std::vector<Piece>& pieces_;
  std::vector<bool> seen_;
  std::map<BlockId, std::size_t> places_;
};

}  // namespace

std::vector<Piece> pieces(const project::Project& project, const Style& style) {
  std::vector<Piece> list;
  for (const source::SourceFile& file : project.sources) {
    std::size_t begin = 0;
    const auto blocks = blocksOf(file, project);
    for (const BlockSource& block : blocks) {
      const bool last = &block == &blocks.back();
      const std::size_t end = last ? file.text().size() : endOf(block);
      list.push_back(
          {block.id,
           withLineFeeds(edited(file.text(), begin, end, editsOf(block, project.symbols, style))),
           usesOf(block, project.symbols)});
      begin = end;
    }
  }
  return list;
}

std::vector<Piece> ordered(std::vector<Piece> pieces) { return Order(pieces).take(); }

Mnemonics mnemonicsOf(const project::Project& project) {
  if (project.mnemonics) return *project.mnemonics;
  for (const source::SourceFile& file : project.sources)
    for (const BlockSource& block : blocksOf(file, project))
      if (block.mnemonics == Mnemonics::International) return Mnemonics::International;
  return Mnemonics::German;
}

}  // namespace merker::exporting
