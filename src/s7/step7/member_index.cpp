#include "step7/member_index.h"

#include "base/text.h"
#include "step7/path.h"

namespace merker::step7 {

constexpr std::size_t kShort = 32;  // found as fast without

const block::Variable* MemberIndex::find(const std::vector<block::Variable>& members,
                                         std::string_view name) {
  if (members.size() < kShort) return findMember(members, name);
  const auto [list, isNew] = lists_.try_emplace(members.data());
  if (isNew)  // of two with one name the first
    for (std::size_t i = 0; i < members.size(); ++i)
      list->second.emplace(upper(members[i].name), i);
  const auto found = list->second.find(upper(name));
  return found == list->second.end() ? nullptr : &members[found->second];
}

}  // namespace merker::step7
