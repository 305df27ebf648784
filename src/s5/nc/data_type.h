// The data types that FB 61 and FB 62 transfer: limits, formats, numbers of values (6.3 FB 61/62
// section 7, S5-FM-42). One table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "nc/control.h"
#include "nc/number_format.h"

namespace merker::nc {

enum class Model : std::uint8_t { Turning, Milling, Nibbling, Grinding };  // T, M, N, G

// WER1, WER2, WER3.
using Where = std::array<int, 3>;

struct Limit {
  int low = 0, high = -1;
  bool used() const { return high >= low; }
};

struct DataType {
  std::string_view name;  // DTY1 … DTY3
  std::array<Limit, 3> limits;
  FormatSet read, write;  // FB 61, FB 62; none: no transfer
  unsigned most;          // largest ANZ
  unsigned counted;       // which of WER1 … 3 is incremented; 0: none
  unsigned each;          // values delivered for ANZ = 1
  Content content;
  // `part` counts the values of one job. Nothing, false: such a value cannot be.
  std::optional<Number> (*get)(const Control&, const Where&, unsigned part);
  bool (*put)(Control&, const Where&, Number);
  enum class On : std::uint8_t { All, Grinding, Others } on = On::All;
};

std::span<const DataType> dataTypes();
// A name may have several rows; WER1 says which (R parameters). Null if the NC does not know it.
const DataType* findDataType(std::string_view name, const Where& where, Model model);
bool withinLimits(const DataType& type, const Where& where);

}  // namespace merker::nc
