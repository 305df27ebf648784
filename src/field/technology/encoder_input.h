// Evaluation of the two tracks, or of pulse and direction (technology manual 5.10.2; CNT-ENC).
#pragma once

#include "io/count_channel.h"

namespace merker::technology {

// Which way an edge counts: +1, -1, or 0 if it does not. `level` is the new level of the track that
// changed, `other` that of the other one; an inverted direction has turned B before.
int edgeOfA(io::Evaluation evaluation, bool level, bool b);
int edgeOfB(io::Evaluation evaluation, bool level, bool a);

}  // namespace merker::technology
