// A sum that grows by the same number again and again, without taking each step.
#pragma once

#include <cstdint>

namespace merker::plant {

// What `count` additions of `summand` to `sum` come to, to the last bit: each is rounded to
// nearest. Between two powers of two every addition adds the same, so that it takes a few
// operations for each of these that the sum passes.
double addRepeatedly(double sum, double summand, std::int64_t count);

}  // namespace merker::plant
