// Variables of long lists by their names: a block has up to twenty thousand, and its statements
// name them as often.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "block/type.h"

namespace merker::step7 {

class MemberIndex {
 public:
  // As findMember. The list must stay where it is and as it is as long as this index.
  const block::Variable* find(const std::vector<block::Variable>& members, std::string_view name);

 private:
  using Names = std::unordered_map<std::string, std::size_t>;
  std::map<const block::Variable*, Names> lists_;  // by their beginnings
};

}  // namespace merker::step7
