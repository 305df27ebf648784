// Why a network has no picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "graph/language.h"

namespace merker::graph {

enum class Reason : std::uint8_t {
#define REASON(id, english, german) id,
#include "graph/reasons.inc"
#undef REASON
};

std::string_view text(Reason reason, Language language = Language::English);

struct Refusal {
  std::size_t statement = 0;  // number of the statement that is to blame
  Reason reason = Reason::Operation;
};

}  // namespace merker::graph
