// Six of the measured programs as somebody writes them in C: the same work on the same variables,
// with the types and the byte order of this computer and without status bits. gcc -O2 compiles
// them; compiled AWL is measured against it.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct ReferenceTimer {
  int64_t end;  // ns
  bool running, edge;
};
struct ReferenceCounter {
  int16_t count;
  bool edge;
};

struct ReferenceMemory {
  uint8_t inputs[128], outputs[128], flags[256];
  struct ReferenceTimer timer;
  struct ReferenceCounter counter;
  int64_t now;  // ns
};

// The loops 1,000 times, the calls 500 times.
void reference_mixed(struct ReferenceMemory* m);
void reference_reals(struct ReferenceMemory* m);
void reference_indirect(struct ReferenceMemory* m);
void reference_timers(struct ReferenceMemory* m);
void reference_function_calls(struct ReferenceMemory* m);
void reference_function_block_calls(struct ReferenceMemory* m);

#ifdef __cplusplus
}
#endif
