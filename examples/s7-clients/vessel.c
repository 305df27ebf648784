/* Watches the vessel of chapter 4.2 over S7 communication, as an application of one's own would: prints what changes.
 *
 *   merker run examples/vessel-emptying --s7 10102
 *   cc vessel.c -lmerker-s7 -o vessel && ./vessel 127.0.0.1 10102
 */
#define _POSIX_C_SOURCE 199309L
#include <merker_s7.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* E 0.0 to E 0.3 and A 1.0 to A 1.2, as the symbols of the project name them. */
static const char *const kInputs[] = {"Start", "Stop", "Level min", "Level max"};
static const char *const kOutputs[] = {"Outlet valve", "Inlet valve", "Lamp emptying"};

static int fail(const char *what, int error) {
  char text[120];
  Cli_ErrorText(error, text, sizeof text);
  fprintf(stderr, "%s: %s\n", what, text);
  return 1;
}

static void show(const char *const *names, int count, unsigned now, unsigned before) {
  for (int bit = 0; bit < count; ++bit)
    if (((now ^ before) >> bit & 1) != 0) printf("%-14s %u\n", names[bit], now >> bit & 1);
}

/* One request for both bytes, ten times a second; `rounds` of them. */
static int watch(S7Object plc, int rounds) {
  uint8_t inputs = 0, outputs = 0;
  unsigned lastInputs = 0, lastOutputs = 0;
  const struct timespec pause = {0, 100 * 1000 * 1000};
  while (rounds-- > 0) {
    TS7DataItem items[] = {{S7AreaPE, S7WLByte, 0, 0, 0, 1, &inputs}, {S7AreaPA, S7WLByte, 0, 0, 1, 1, &outputs}};
    const int error = Cli_ReadMultiVars(plc, items, 2);
    if (error != 0) return fail("reading", error);
    show(kInputs, 4, inputs, lastInputs);
    show(kOutputs, 3, outputs, lastOutputs);
    fflush(stdout);
    lastInputs = inputs;
    lastOutputs = outputs;
    nanosleep(&pause, NULL);
  }
  return 0;
}

int main(int argc, char **argv) {
  S7Object plc = Cli_Create();
  uint16_t port = argc > 2 ? (uint16_t)atoi(argv[2]) : 102;
  const int rounds = argc > 3 ? atoi(argv[3]) : 1000000;
  Cli_SetParam(plc, p_u16_RemotePort, &port);
  const int error = Cli_ConnectTo(plc, argc > 1 ? argv[1] : "127.0.0.1", 0, 2);
  const int code = error != 0 ? fail("connecting", error) : watch(plc, rounds);
  Cli_Destroy(&plc);
  return code;
}
