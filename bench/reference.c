#include "reference.h"

#include <string.h>

// Behind each turn memory is as the program says: an interrupt or a programming device may look.
// So no turn can be left out, and nothing is moved out of the loop.
#define SEEN __asm__ volatile("" ::: "memory")
// Blocks are loaded one by one: no compiler sees two of them at a time.
#define BLOCK __attribute__((noipa))

enum { kTurns = 1000, kCalls = 500 };

static int16_t word(const uint8_t* at) {
  int16_t value;
  memcpy(&value, at, sizeof value);
  return value;
}
static void set_word(uint8_t* at, int16_t value) { memcpy(at, &value, sizeof value); }
static int32_t dword(const uint8_t* at) {
  int32_t value;
  memcpy(&value, at, sizeof value);
  return value;
}
static void set_dword(uint8_t* at, int32_t value) { memcpy(at, &value, sizeof value); }
static float real(const uint8_t* at) {
  float value;
  memcpy(&value, at, sizeof value);
  return value;
}
static void set_real(uint8_t* at, float value) { memcpy(at, &value, sizeof value); }
static bool bit(const uint8_t* bytes, unsigned byte, unsigned number) {
  return (bytes[byte] >> number & 1) != 0;
}
static void set_bit(uint8_t* bytes, unsigned byte, unsigned number, bool value) {
  bytes[byte] = (uint8_t)((bytes[byte] & ~(1u << number)) | (unsigned)value << number);
}

void reference_mixed(struct ReferenceMemory* m) {
  for (int turn = 0; turn < kTurns; ++turn) {
    set_word(m->flags + 14, (int16_t)((word(m->flags + 12) + word(m->flags + 14)) * 2));
    set_dword(m->flags + 20, (int32_t)((uint32_t)dword(m->flags + 20) + 5));
    set_bit(m->outputs, 4, 0, bit(m->inputs, 0, 1) && bit(m->flags, 3, 2));
    if (word(m->flags + 14) <= 100) set_word(m->flags + 12, (int16_t)(word(m->flags + 12) + 1));
    SEEN;
  }
}

void reference_reals(struct ReferenceMemory* m) {
  for (int turn = 0; turn < kTurns; ++turn) {
    const float value = (real(m->flags + 20) * 1.5F - 2.5F) / 3.0F;
    set_real(m->flags + 28, value + real(m->flags + 24));
    SEEN;
  }
}

void reference_indirect(struct ReferenceMemory* m) {
  for (int turn = 0; turn < kTurns; ++turn) {
    uint32_t ar1 = 10 * 8;
    const uint8_t* const by_memory = m->flags + ((uint32_t)dword(m->flags + 60) >> 3 & 0xFF);
    const int sum = word(m->flags + ar1 / 8) + word(by_memory);
    set_word(m->flags + ar1 / 8 + 8, (int16_t)sum);
    set_bit(m->outputs, ar1 / 8, 1, bit(m->flags, ar1 / 8 + 1, 3));
    SEEN;
  }
}

// On-delay of 2 s in units of 10 ms, and what is left of it.
static bool on_delay(struct ReferenceTimer* timer, bool input, int64_t now) {
  const int64_t kTime = 2000000000;
  if (input && !timer->edge) timer->running = true, timer->end = now + kTime;
  if (!input) timer->running = false;
  timer->edge = input;
  return timer->running && now >= timer->end;
}
static int16_t rest(const struct ReferenceTimer* timer, int64_t now) {
  const int64_t kUnit = 10000000;
  if (!timer->running || now >= timer->end) return 0;
  return (int16_t)((timer->end - now + kUnit - 1) / kUnit);
}
static bool count_up(struct ReferenceCounter* counter, bool input) {
  if (input && !counter->edge && counter->count < 999) ++counter->count;
  counter->edge = input;
  return counter->count > 0;
}

void reference_timers(struct ReferenceMemory* m) {
  for (int turn = 0; turn < kTurns; ++turn) {
    set_bit(m->outputs, 4, 0, on_delay(&m->timer, bit(m->inputs, 0, 1), m->now));
    set_word(m->flags + 30, rest(&m->timer, m->now));
    set_bit(m->outputs, 4, 1, count_up(&m->counter, bit(m->inputs, 0, 2)));
    SEEN;
  }
}

static BLOCK void function(int16_t a, int16_t b, bool c, int16_t* d, bool* e) {
  *d = (int16_t)(a + b);
  *e = c;
}

void reference_function_calls(struct ReferenceMemory* m) {
  for (int call = 0; call < kCalls; ++call) {
    int16_t d;
    bool e;
    function(word(m->flags + 10), word(m->flags + 12), bit(m->flags, 2, 0), &d, &e);
    set_word(m->flags + 14, d);
    set_bit(m->flags, 2, 1, e);
    SEEN;
  }
}

struct Instance {
  int16_t a, b;
  bool c;
  int16_t d;
  bool e;
};

static BLOCK void function_block(struct Instance* instance) {
  instance->d = (int16_t)(instance->a + instance->b);
  instance->e = instance->c;
}

void reference_function_block_calls(struct ReferenceMemory* m) {
  static struct Instance instance;
  for (int call = 0; call < kCalls; ++call) {
    instance.a = word(m->flags + 10);
    instance.b = word(m->flags + 12);
    instance.c = bit(m->flags, 2, 0);
    function_block(&instance);
    set_word(m->flags + 14, instance.d);
    set_bit(m->flags, 2, 1, instance.e);
    SEEN;
  }
}
