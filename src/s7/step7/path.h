// Components of a variable: .member, [index, index] and the [index] of a character behind its name
// (S7-TYPES-19, -20, -21).
#pragma once

#include <vector>

#include "block/type.h"
#include "source/source_file.h"
#include "step7/cursor.h"
#include "step7/member_index.h"

namespace merker::step7 {

struct Place {
  block::TypePtr type;
  BitAddress address = 0;
};

// Follows .member and [i] from `place` as long as they stand at the cursor. False after a problem.
// `index`, if there is one, finds the members.
bool followPath(Cursor& cursor, Place& place, const source::SourceFile& file, Problems& problems,
                MemberIndex* index = nullptr);

const block::Variable* findMember(const std::vector<block::Variable>& members,
                                  std::string_view name);

}  // namespace merker::step7
