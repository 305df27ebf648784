#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "s5d/block_bytes.h"
#include "s5d/comments.h"
#include "s5d/lines.h"
#include "s5d/pre_header.h"
#include "s5d/program.h"

namespace merker::s5d {
namespace {

constexpr std::uint16_t kHighestOb = 63;  // S5-BLK-03
constexpr std::uint32_t kHighestLibrary = 99999;
constexpr std::size_t kMostNotes = 200;

class Reader {
 public:
  Reader(Bytes bytes, Encoding codePage) : codePage_(codePage), file_(readFile(bytes)) {}

  Contents read() {
    result_.name = file_.name;
    aboutFile();
    for (const Record& record : file_.records) take(record);
    for (const Record& record : file_.deleted) takeDeleted(record);
    if (documents_ > 0)
      note("", fmt::format("{} records are texts or pictures of STEP 5; they are not read",
                           documents_));
    for (auto& [id, block] : result_.program) networks(block);
    for (auto& [id, block] : result_.program) formats(block);
    for (auto& [id, block] : result_.program) labels(block);
    for (auto& [id, block] : result_.program) comments(block);
    for (auto& [id, block] : result_.deleted) networks(block);
    return std::move(result_);
  }

 private:
  void note(std::string block, std::string text, bool lost = true) {
    if (++notes_ == kMostNotes) {
      block.clear();
      text = "what else did not come is not listed";
    }
    if (notes_ <= kMostNotes) result_.notes.push_back({std::move(block), std::move(text), lost});
  }

  void aboutFile() {
    if (file_.withoutDirectory)
      note("",
           "the directory of the file is damaged; its blocks were found by their marks, and "
           "deleted ones may be among them",
           false);
    else if (file_.badSections > 0)
      note("", fmt::format("{} sections of the directory lead nowhere", file_.badSections));
  }

  void take(const Record& record) {
    if (record.kind == nullptr || record.kind->group == Group::Document) return document(record);
    if (record.kind->group == Group::Code || record.kind->group == Group::Data)
      return block(record);
    if (!record.kind->block) return;  // the block itself is reported
    const mc5::BlockId id{*record.kind->block, record.number};
    auto& list = record.kind->group == Group::Comments ? comments_ : preHeaders_;
    list.emplace(id, &record);
  }

  void document(const Record& record) {
    if (std::ranges::any_of(record.bytes, [](std::uint8_t byte) { return byte != 0; }))
      ++documents_;
  }

  void block(const Record& record) {
    BlockOrReason read = readBlock(record, codePage_);
    if (!read.block) return note(record.name(), read.reason);
    const mc5::BlockId id = read.block->id;
    const bool data = id.type == mc5::BlockType::Db;
    if ((data && id.number == 0) || (id.type == mc5::BlockType::Ob && id.number > kHighestOb))
      return note(record.name(), "SINUMERIK 810/820 has no block of this number");
    if (read.block->library > kHighestLibrary) {
      note(record.name(),
           fmt::format("its library number {} has more than five digits; it is left "
                       "out",
                       read.block->library),
           false);
      read.block->library = 0;
    }
    if (!result_.program.emplace(id, std::move(*read.block)).second)
      note(record.name(), "the file has it twice; the first one was taken");
  }

  void takeDeleted(const Record& record) {
    const BlockOrReason read = readBlock(record, codePage_);
    const bool whole = record.kind->group == Group::Code || record.kind->group == Group::Data;
    if (whole && read.block) result_.deleted[read.block->id] = *read.block;
  }

  // BLD 255 separates them; a block with one network alone has no mark of it.
  void networks(mc5::Block& block) {
    if (block.id.type == mc5::BlockType::Db) return;
    const std::vector<std::uint32_t> starts = networkStarts(result_.program, block);
    if (starts.size() > 1)
      for (const std::uint32_t start : starts) block.networks.push_back({start, ""});
  }

  void formats(mc5::Block& block) {
    const auto found = preHeaders_.find(block.id);
    if (block.id.type != mc5::BlockType::Db || found == preHeaders_.end()) return;
    if (!readFormats(found->second->bytes, block))
      note(found->second->name(), "it is damaged; data words without a format are shown as KH",
           false);
  }

  // Only in front of statements.
  void labels(mc5::Block& block) {
    const auto found = preHeaders_.find(block.id);
    if (block.id.type != mc5::BlockType::Fb || found == preHeaders_.end()) return;
    readLabels(found->second->bytes, block);
    std::set<std::uint32_t> starts;
    for (const CommentLine& line : commentLines(result_.program, block)) starts.insert(line.offset);
    std::erase_if(block.labels, [&](const auto& label) { return !starts.contains(label.first); });
  }

  void comments(mc5::Block& block) {
    const auto found = comments_.find(block.id);
    if (found == comments_.end()) return;
    const Record& record = *found->second;
    const std::size_t lost = readComments(record.bytes, result_.program, codePage_, block);
    if (lost > 0)
      note(record.name(),
           fmt::format("{} comments belong to lines that the block does not have", lost));
    for (const mc5::Comment& comment : block.comments) ascii(comment.text);
    for (const mc5::Network& network : block.networks) ascii(network.title);
  }

  void ascii(const std::string& text) {
    result_.beyondAscii |=
        std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  }

  Encoding codePage_;
  File file_;
  Contents result_;
  std::size_t notes_ = 0, documents_ = 0;
  std::map<mc5::BlockId, const Record*> comments_, preHeaders_;
};

}  // namespace

Contents readProgram(Bytes file, Encoding codePage) { return Reader(file, codePage).read(); }

}  // namespace merker::s5d
