#include "s5d/listings.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "mc5/block_id.h"
#include "step5/compiler.h"

namespace merker::s5d {
namespace {

constexpr const char* kDeleted = "deleted/";
constexpr const char* kUnfit = "not-compiled/";

// "PB5.s5"
std::string fileOf(mc5::BlockId id) {
  std::string name = mc5::toString(id);
  std::erase(name, ' ');
  return name + ".s5";
}

class Maker {
 public:
  Maker(const Contents& contents, const source::SymbolTable& symbols)
      : contents_(contents), symbols_(symbols) {}

  Listings make() {
    for (const auto& [id, block] : contents_.program)
      texts_[id] = step5::listing(contents_.program, block, &symbols_);
    for (const mc5::BlockId id : failing())
      texts_[id] = step5::listing(contents_.program, contents_.program.at(id));
    setAside(failing());
    for (const auto& [id, text] : texts_) result_.files.push_back({fileOf(id), text});
    result_.blocks = texts_.size();
    for (const auto& [id, block] : contents_.deleted) deleted(block);
    return std::move(result_);
  }

 private:
  // Blocks whose listing does not compile to their words.
  std::set<mc5::BlockId> failing() {
    std::vector<source::SourceFile> files;
    for (const auto& [id, text] : texts_) files.emplace_back(fileOf(id), text);
    const step5::Compilation compilation = step5::compile(files, false, {}, &symbols_);
    std::set<mc5::BlockId> list;
    for (const auto& [id, text] : texts_) {
      const auto found = compilation.program.find(id);
      const mc5::Block& wanted = contents_.program.at(id);
      if (found == compilation.program.end() || found->second.words != wanted.words)
        list.insert(id);
    }
    reasons_.clear();
    for (const Problem& problem : compilation.problems.list())
      if (problem.severity() == Severity::Error)
        reasons_.emplace(problem.position.file,
                         fmt::format("line {}: {}", problem.position.line, problem.message));
    return list;
  }

  void setAside(const std::set<mc5::BlockId>& unfit) {
    for (const mc5::BlockId id : unfit) {
      const auto reason = reasons_.find(fileOf(id));
      const std::string path = kUnfit + fileOf(id) + ".txt";
      result_.notes.push_back(
          {mc5::toString(id),
           fmt::format(
               "it is not in the program but in {}: {}", path,
               reason == reasons_.end() ? "its listing compiles to other code" : reason->second)});
      result_.files.push_back({path, texts_.at(id)});
      texts_.erase(id);
    }
  }

  void deleted(const mc5::Block& block) {
    const std::string path = kDeleted + fileOf(block.id) + ".txt";
    result_.files.push_back({path, step5::listing(contents_.program, block)});
    result_.notes.push_back({mc5::toString(block.id),
                             fmt::format("a deleted version of it was found; it is in {}", path),
                             false});
  }

  const Contents& contents_;
  const source::SymbolTable& symbols_;
  std::map<mc5::BlockId, std::string> texts_;
  std::map<std::string, std::string> reasons_;  // by file; the first one
  Listings result_;
};

}  // namespace

Listings listings(const Contents& contents, const source::SymbolTable& symbols) {
  return Maker(contents, symbols).make();
}

}  // namespace merker::s5d
