#include "graph5/rules.h"

namespace merker::graph5 {
namespace {

using graph::ElementClass;
using graph::ElementRow;
using graph::Eno;

constexpr ElementRow kRows[] = {
#define BOX(id, name, kind, pattern) \
  {id, name, name, name, name, ElementClass::kind, Eno::None, pattern, "", ""},
#define COIL(id, kop, fup, pattern, say, sayEnglish) \
  {id, kop, kop, fup, fup, ElementClass::Coil, Eno::None, pattern, say, sayEnglish},
#define RAIL(id, kop, fup, pattern, say, sayEnglish) \
  {id, kop, kop, fup, fup, ElementClass::RailCoil, Eno::None, pattern, say, sayEnglish},
#include "graph5/elements.inc"
#undef BOX
#undef COIL
#undef RAIL
};

constexpr int kLevels = 8;  // S5-KOPFUP-03

}  // namespace

const graph::Rules& rules() {
  static const graph::ElementTable table(kRows);
  static const graph::Rules kRules{&table, kLevels, {}, {}, true, false, false, false};
  return kRules;
}

}  // namespace merker::graph5
