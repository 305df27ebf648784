#include "workbench/start_declaration.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace merker::workbench {
namespace {

struct Declared {
  std::string_view name, type;  // the name without the number of the OB in front
};
struct Row {
  std::uint32_t first, last;  // organization blocks
  std::span<const Declared> own;
};

// Bytes 1, 4 to 11; the others are the same in all (S7-OBI-01).
constexpr Declared kCycle[] = {{"SCAN_1", "BYTE"},     {"RESERVED_1", "BYTE"},
                               {"RESERVED_2", "BYTE"}, {"PREV_CYCLE", "INT"},
                               {"MIN_CYCLE", "INT"},   {"MAX_CYCLE", "INT"}};  // S7-OBI-02
constexpr Declared kTimeOfDay[] = {{"STRT_INFO", "BYTE"},  {"RESERVED_1", "BYTE"},
                                   {"RESERVED_2", "BYTE"}, {"PERIOD_EXE", "WORD"},
                                   {"RESERVED_3", "INT"},  {"RESERVED_4", "INT"}};  // S7-OBI-03
constexpr Declared kDelay[] = {{"STRT_INF", "BYTE"},
                               {"RESERVED_1", "BYTE"},
                               {"RESERVED_2", "BYTE"},
                               {"SIGN", "WORD"},
                               {"DTIME", "TIME"}};  // S7-OBI-04
constexpr Declared kCyclic[] = {{"STRT_INF", "BYTE"},   {"RESERVED_1", "BYTE"},
                                {"RESERVED_2", "BYTE"}, {"PHASE_OFFSET", "WORD"},
                                {"RESERVED_3", "INT"},  {"EXC_FREQ", "INT"}};  // S7-OBI-05
constexpr Declared kHardware[] = {{"STRT_INF", "BYTE"},
                                  {"RESERVED_1", "BYTE"},
                                  {"IO_FLAG", "BYTE"},
                                  {"MDL_ADDR", "WORD"},
                                  {"POINT_ADDR", "DWORD"}};  // S7-OBI-06
constexpr Declared kTimeError[] = {{"FLT_ID", "BYTE"},       {"RESERVED_1", "BYTE"},
                                   {"RESERVED_2", "BYTE"},   {"ERROR_INFO", "WORD"},
                                   {"ERR_EV_CLASS", "BYTE"}, {"ERR_EV_NUM", "BYTE"},
                                   {"OB_PRIORITY", "BYTE"},  {"OB_NUM", "BYTE"}};  // S7-OBI-07
constexpr Declared kPower[] = {{"FLT_ID", "BYTE"},     {"RESERVED_1", "BYTE"},
                               {"RESERVED_2", "BYTE"}, {"RACK_CPU", "WORD"},
                               {"RESERVED_3", "BYTE"}, {"RESERVED_4", "BYTE"},
                               {"RESERVED_5", "BYTE"}, {"RESERVED_6", "BYTE"}};  // S7-OBI-08
constexpr Declared kDiagnostic[] = {
    {"FLT_ID", "BYTE"},        {"RESERVED_1", "BYTE"},     {"IO_FLAG", "BYTE"},
    {"MDL_ADDR", "WORD"},      {"MDL_DEFECT", "BOOL"},     {"INT_FAULT", "BOOL"},
    {"EXT_FAULT", "BOOL"},     {"PNT_INFO", "BOOL"},       {"EXT_VOLTAGE", "BOOL"},
    {"FLD_CONNCTR", "BOOL"},   {"NO_CONFIG", "BOOL"},      {"CONFIG_ERR", "BOOL"},
    {"MDL_TYPE", "BYTE"},      {"SUB_MDL_ERR", "BOOL"},    {"COMM_FAULT", "BOOL"},
    {"MDL_STOP", "BOOL"},      {"WTCH_DOG_FLT", "BOOL"},   {"INT_PS_FLT", "BOOL"},
    {"PRIM_BATT_FLT", "BOOL"}, {"BCKUP_BATT_FLT", "BOOL"}, {"RESERVED_2", "BOOL"},
    {"RACK_FLT", "BOOL"},      {"PROC_FLT", "BOOL"},       {"EPROM_FLT", "BOOL"},
    {"RAM_FLT", "BOOL"},       {"ADU_FLT", "BOOL"},        {"FUSE_FLT", "BOOL"},
    {"HW_INTR_FLT", "BOOL"},   {"RESERVED_3", "BOOL"}};  // S7-OBI-09
constexpr Declared kProgram[] = {{"FLT_ID", "BYTE"},       {"RESERVED_1", "BYTE"},
                                 {"RESERVED_2", "BYTE"},   {"RESERVED_3", "INT"},
                                 {"ERR_EV_CLASS", "BYTE"}, {"ERR_EV_NUM", "BYTE"},
                                 {"OB_PRIOR", "BYTE"},     {"OB_NUM", "BYTE"}};  // S7-OBI-10
constexpr Declared kRack[] = {{"FLT_ID", "BYTE"},
                              {"RESERVED_1", "BYTE"},
                              {"RESERVED_2", "BYTE"},
                              {"MDL_ADDR", "WORD"},
                              {"RACKS_FLTD", "ARRAY [0 .. 31] OF BOOL"}};  // S7-OBI-11
constexpr Declared kStartUp[] = {{"STRTUP", "BYTE"},
                                 {"RESERVED_1", "BYTE"},
                                 {"RESERVED_2", "BYTE"},
                                 {"STOP", "WORD"},
                                 {"STRT_INFO", "DWORD"}};  // S7-OBI-12
constexpr Declared kProgramming[] = {{"SW_FLT", "BYTE"},     {"BLK_TYPE", "BYTE"},
                                     {"RESERVED_1", "BYTE"}, {"FLT_REG", "WORD"},
                                     {"BLK_NUM", "WORD"},    {"PRG_ADDR", "WORD"}};  // S7-OBI-13
constexpr Declared kAccess[] = {{"SW_FLT", "BYTE"},   {"BLK_TYPE", "BYTE"},
                                {"MEM_AREA", "BYTE"}, {"MEM_ADDR", "WORD"},
                                {"BLK_NUM", "WORD"},  {"PRG_ADDR", "WORD"}};  // S7-OBI-15
// Of any other block what SFC 6 RD_SINFO calls the same bytes.
constexpr Declared kAny[] = {
    {"EV_NUM", "BYTE"}, {"TYP2_3", "BYTE"}, {"TYP1", "BYTE"}, {"ZI1", "WORD"}, {"ZI2_3", "DWORD"}};

constexpr Row kRows[] = {{1, 1, kCycle},     {10, 17, kTimeOfDay},  {20, 23, kDelay},
                         {30, 38, kCyclic},  {40, 47, kHardware},   {80, 80, kTimeError},
                         {81, 81, kPower},   {82, 82, kDiagnostic}, {85, 85, kProgram},
                         {86, 86, kRack},    {100, 102, kStartUp},  {121, 121, kProgramming},
                         {122, 122, kAccess}};

std::span<const Declared> ownOf(std::uint32_t ob) {
  const auto* const row = std::ranges::find_if(
      kRows, [ob](const Row& one) { return ob >= one.first && ob <= one.last; });
  return row == std::end(kRows) ? kAny : row->own;
}

}  // namespace

std::string startDeclaration(std::uint32_t ob) {
  std::string text = "VAR_TEMP\n";
  const auto add = [&](const Declared& one) {
    text += fmt::format("  OB{}_{} : {} ;\n", ob, one.name, one.type);
  };
  const auto own = ownOf(ob);
  add({"EV_CLASS", "BYTE"});
  add(own.front());
  add({"PRIORITY", "BYTE"});
  add({"OB_NUMBR", "BYTE"});
  std::ranges::for_each(own.subspan(1), add);
  add({"DATE_TIME", "DATE_AND_TIME"});
  return text + "END_VAR\n";
}

}  // namespace merker::workbench
