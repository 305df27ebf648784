// One term of a check (//=) on the machine as it stands.
#pragma once

#include <optional>
#include <string>

#include "check/check.h"
#include "softplc/processor.h"

namespace merker::sinumerik {

// What is wrong with the term: "is KH 7FFF"; nothing if it holds. Changes nothing.
std::optional<std::string> judge(Processor& processor, const block::CheckTerm& term);

}  // namespace merker::sinumerik
