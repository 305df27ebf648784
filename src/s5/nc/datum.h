// The data of the NC by name, for whoever looks from outside: "nc.R 50", "nc.tool 5.2". One table
// says what there is; scenarios, --set, --print, traces, the workbench and [nc] of merker.toml use
// it (docs/formats/nc.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nc/data_type.h"

namespace merker::nc {

struct DatumRow {
  std::string_view name, alias;    // lower case; the alias may be empty
  std::string_view index;          // "channel.number": what its numbers mean
  std::array<Limit, 3> limits;     // of these numbers
  std::optional<int> first, last;  // numbers that may be left out, and stand for these
  Content content = Content::Whole;
  std::int32_t lowest = 0, highest = 0;  // of a whole number
  std::string_view unit;
  std::optional<Number> (*get)(const Control&, const Where&, unsigned);
  bool (*put)(Control&, const Where&, Number) = nullptr;  // null: it is only read
  bool setting = true;                                    // [nc] of merker.toml has it, too
};
std::span<const DatumRow> datumRows();
unsigned indexCount(const DatumRow& row);

// A value of a row.
struct Datum {
  unsigned row = 0;
  Where where{};
};
const DatumRow& rowOf(const Datum& datum);
// In 32 bits, never 0.
std::uint32_t pack(const Datum& datum);
Datum unpack(std::uint32_t packed);

// Whether the text means to name a datum: "nc." in upper or lower case.
bool namesDatum(std::string_view text);
// "nc.tool 5.2"; nothing if there is no such datum.
std::optional<Datum> parseDatum(std::string_view text);
// What there is in place of a text that names nothing: the indices of its row, or all names.
std::string knownData(std::string_view text);

// "-12.345": digits with a point. Nothing if it is no number of up to eight places.
std::optional<Number> parseDecimal(std::string_view text);
std::string formatDecimal(Number number);

std::string readDatum(const Control& control, const Datum& datum);
// False: it takes no such number.
bool writeDatum(Control& control, const Datum& datum, Number number);
// Whether it takes these digits. Nothing is changed.
bool takes(const Control& control, const Datum& datum, std::string_view digits);
// "it takes whole numbers from 1 to 4"
std::string whatItTakes(const Datum& datum);

}  // namespace merker::nc
