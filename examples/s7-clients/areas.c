/* Reads and writes the areas of a PLC by their operands, as an application of one's own would (chapter 4.2).
 *
 *   merker run examples/vessel-emptying --s7 10102
 *   ./areas 127.0.0.1 10102 EB0 A0.0 AB1 MW10 T1 Z1          reads
 *   ./areas 127.0.0.1 10102 MW10=5 M100.3=1 MB3=16#FF        writes, then reads them again
 *
 * Data of a project that has a data block: DB1.DBW2, DB1.DBX0.1, DB1.DBB0=7.
 */
#include <merker_s7.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct operand {
  int area, db, start, word_length, bytes; /* start: of a bit its number, of a timer or counter too */
};

/* EB 0, MW 10, A 1.0, T 1, Z 1, DB1.DBW 2 without blanks; 0: it is none. %n: nothing may follow. */
static int parse(const char *text, struct operand *found) {
  static const char letters[] = "EIAQM";
  static const int areas[] = {S7AreaPE, S7AreaPE, S7AreaPA, S7AreaPA, S7AreaMK};
  const char *rest = text, *letter;
  char size = 'X';
  int number = 0, bit = -1, end = 0;
  found->db = 0;
  if (sscanf(text, "%*1[TZC]%d%n", &number, &end) == 1 && text[end] == 0) {
    found->area = text[0] == 'T' ? S7AreaTM : S7AreaCT;
    found->word_length = text[0] == 'T' ? S7WLTimer : S7WLCounter;
    found->start = number;
    found->bytes = 2;
    return number >= 0;
  }
  if (sscanf(text, "DB%d.D%n", &found->db, &end) == 1 && end > 0) {
    found->area = S7AreaDB;
  } else {
    letter = text[0] != 0 ? strchr(letters, text[0]) : NULL;
    if (letter == NULL) return 0;
    found->area = areas[letter - letters];
    end = 0;
  }
  rest = text + end + 1; /* behind E, A, M, or the D of DBW */
  if (strchr("XBWD", *rest) != NULL && *rest != 0) size = *rest++;
  end = 0;
  if (sscanf(rest, "%d%n.%d%n", &number, &end, &bit, &end) < 1 || rest[end] != 0) return 0;
  found->bytes = size == 'D' ? 4 : size == 'W' ? 2 : 1;
  found->word_length = bit >= 0 ? S7WLBit : S7WLByte;
  found->start = bit >= 0 ? number * 8 + bit : number;
  return number >= 0 && bit < 8 && (bit >= 0) == (size == 'X');
}

/* 5, 16#FF, 0xFF: so many bits at most; 0: it is none. */
static int parse_value(const char *text, int bits, unsigned long *value) {
  char *end = NULL;
  const int hexadecimal = strncmp(text, "16#", 3) == 0;
  if (hexadecimal) text += 3;
  if (*text < '0' || (*text > '9' && !hexadecimal)) return 0;
  *value = strtoul(text, &end, hexadecimal ? 16 : 0);
  return *end == 0 && *value <= 0xFFFFFFFFUL >> (32 - bits);
}

/* The most significant byte first, as a PLC has it. */
static int transfer(S7Object plc, const struct operand *at, int write, unsigned long *value) {
  const int cell = at->word_length == S7WLTimer || at->word_length == S7WLCounter;
  const int amount = cell ? 1 : at->bytes;
  uint8_t bytes[4] = {0};
  for (int i = 0; write && i < at->bytes; ++i) bytes[i] = (uint8_t)(*value >> 8 * (at->bytes - 1 - i));
  const int error = write ? Cli_WriteArea(plc, at->area, at->db, at->start, amount, at->word_length, bytes)
                          : Cli_ReadArea(plc, at->area, at->db, at->start, amount, at->word_length, bytes);
  if (error != 0 || write) return error;
  *value = 0;
  for (int i = 0; i < at->bytes; ++i) *value = *value << 8 | bytes[i];
  return 0;
}

static int carry_out(S7Object plc, const char *argument) {
  char text[40], why[120];
  struct operand at;
  const char *const equals = strchr(argument, '=');
  const size_t length = equals != NULL ? (size_t)(equals - argument) : strlen(argument);
  snprintf(text, sizeof text, "%.*s", (int)length, argument);
  if (!parse(text, &at)) return fprintf(stderr, "%s: must be like EB0, M0.3, MW10, T1, Z1 or DB1.DBW2\n", text), 2;
  const int bits = at.word_length == S7WLBit ? 1 : 8 * at.bytes;
  unsigned long value = 0;
  if (equals != NULL && !parse_value(equals + 1, bits, &value))
    return fprintf(stderr, "%s: must be a number with at most %d bit(s), like 5 or 16#FF\n", argument, bits), 2;
  int error = equals != NULL ? transfer(plc, &at, 1, &value) : 0;
  if (error == 0) error = transfer(plc, &at, 0, &value);
  if (error != 0) {
    Cli_ErrorText(error, why, sizeof why);
    return fprintf(stderr, "%s: %s\n", text, why), 1;
  }
  printf("%s = %lu (16#%0*lX)\n", text, value, at.bytes * 2, value);
  return 0;
}

int main(int count, char **arguments) {
  if (count < 4) return fputs("usage: areas ADDRESS PORT OPERAND[=VALUE]...\n", stderr), 2;
  S7Object plc = Cli_Create();
  uint16_t port = (uint16_t)atoi(arguments[2]);
  char why[120];
  Cli_SetParam(plc, p_u16_RemotePort, &port);
  int code = Cli_ConnectTo(plc, arguments[1], 0, 2);
  if (code != 0) Cli_ErrorText(code, why, sizeof why), fprintf(stderr, "connecting: %s\n", why), code = 1;
  else
    for (int i = 3; i < count && code == 0; ++i) code = carry_out(plc, arguments[i]);
  Cli_Destroy(&plc);
  return code;
}
