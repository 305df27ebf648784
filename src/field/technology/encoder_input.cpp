#include "technology/encoder_input.h"

namespace merker::technology {

// Rising edges always count, falling ones with multiple evaluation: each by the level of B
// (CNT-ENC-01, -02, -04).
int edgeOfA(io::Evaluation evaluation, bool level, bool b) {
  const bool multiple =
      evaluation == io::Evaluation::Double || evaluation == io::Evaluation::Quadruple;
  if (!level && !multiple) return 0;
  return level != b ? 1 : -1;
}

// CNT-ENC-03
int edgeOfB(io::Evaluation evaluation, bool level, bool a) {
  if (evaluation != io::Evaluation::Quadruple) return 0;
  return level == a ? 1 : -1;
}

}  // namespace merker::technology
