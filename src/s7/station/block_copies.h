// The blocks that compiled code may have in itself: short ones that it calls (lowering/callees.h).
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "interpreter/translated.h"
#include "lowering/translate.h"
#include "mc7/listing.h"

namespace merker::station {

// What the CPU, or whoever prepares a program for it, has of a block now; null: nothing.
using FindCode = std::function<const interpreter::Translated*(bool functionBlock, std::uint32_t)>;

// What was asked for while a block was compiled.
struct Asked {
  bool functionBlock;
  std::uint32_t number;
  std::shared_ptr<const int> identity;  // null: such a block must be called
};
// Whether it would be answered the same way now.
bool isSame(const std::vector<Asked>& asked, const FindCode& find);

// Answers for the blocks of one program, which stays as it is meanwhile.
class BlockCopies {
 public:
  explicit BlockCopies(FindCode find) : find_(std::move(find)) {}
  const translate::Callee* callee(bool functionBlock, std::uint32_t number,
                                  std::vector<Asked>& asked);
  const FindCode& find() const { return find_; }

 private:
  struct Source {
    mc7::Listing listing;
    translate::Callee callee;
  };
  FindCode find_;
  std::map<const interpreter::Translated*, Source> sources_;
};

// It calls FCs or FBs by number.
bool callsBlocks(const interpreter::Translated& code);

}  // namespace merker::station
