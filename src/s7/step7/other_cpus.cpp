#include "step7/other_cpus.h"

#include <map>

#include "base/text.h"

namespace merker::step7 {
namespace {

using block::Section;

// Parameters in the order of the interface, as a declaration writes them; a name of a section
// begins it.
struct OtherFunction {
  BlockKind kind;
  std::uint16_t number;
  std::string_view name, parameters;
};

#define MERKER_SEND_DONE "OUT DONE BOOL ERROR BOOL STATUS WORD "
#define MERKER_TEN_VALUES                                                                   \
  "INOUT SD_1 ANY SD_2 ANY SD_3 ANY SD_4 ANY SD_5 ANY SD_6 ANY SD_7 ANY SD_8 ANY SD_9 ANY " \
  "SD_10 ANY"

// System software for S7-300/400, system and standard functions.
constexpr OtherFunction kOtherFunctions[] = {
    {BlockKind::SFC, 12, "D_ACT_DP",
     "IN REQ BOOL MODE BYTE LADDR WORD RETURN RET_VAL INT OUT BUSY BOOL"},
    {BlockKind::SFC, 17, "ALARM_SQ", "IN SIG BOOL ID WORD EV_ID DWORD SD ANY RETURN RET_VAL INT"},
    {BlockKind::SFC, 18, "ALARM_S", "IN SIG BOOL ID WORD EV_ID DWORD SD ANY RETURN RET_VAL INT"},
    {BlockKind::SFC, 19, "ALARM_SC",
     "IN EV_ID DWORD RETURN RET_VAL INT OUT STATE BOOL Q_STATE BOOL"},
    {BlockKind::SFC, 35, "MP_ALM", "IN JOB BYTE RETURN RET_VAL INT"},
    {BlockKind::SFC, 60, "GD_SND", "IN CIRCLE_ID BYTE BLOCK_ID BYTE RETURN RET_VAL INT"},
    {BlockKind::SFC, 61, "GD_RCV", "IN CIRCLE_ID BYTE BLOCK_ID BYTE RETURN RET_VAL INT"},
    {BlockKind::SFC, 82, "CREA_DBL",
     "IN REQ BOOL LOW_LIMIT WORD UP_LIMIT WORD COUNT WORD ATTRIB BYTE SRCBLK ANY RETURN RET_VAL "
     "INT OUT BUSY BOOL DB_NUM WORD"},
    {BlockKind::SFC, 83, "READ_DBL",
     "IN REQ BOOL SRCBLK ANY RETURN RET_VAL INT OUT BUSY BOOL DSTBLK ANY"},
    {BlockKind::SFC, 84, "WRIT_DBL",
     "IN REQ BOOL SRCBLK ANY RETURN RET_VAL INT OUT BUSY BOOL DSTBLK ANY"},
    {BlockKind::SFC, 85, "CREA_DB",
     "IN LOW_LIMIT WORD UP_LIMIT WORD COUNT WORD ATTRIB BYTE RETURN RET_VAL INT OUT DB_NUMBER "
     "WORD"},
    {BlockKind::SFC, 101, "RTM",
     "IN NR BYTE MODE BYTE PV DINT RETURN RET_VAL INT OUT CQ BOOL CV DINT"},
    {BlockKind::SFC, 102, "RD_DPARA",
     "IN REQ BOOL LADDR WORD RECNUM BYTE RETURN RET_VAL INT OUT BUSY BOOL RECORD ANY"},
    {BlockKind::SFC, 107, "ALARM_DQ",
     "IN SIG BOOL ID WORD EV_ID DWORD CMP_ID DWORD SD ANY RETURN RET_VAL INT"},
    {BlockKind::SFC, 108, "ALARM_D",
     "IN SIG BOOL ID WORD EV_ID DWORD CMP_ID DWORD SD ANY RETURN RET_VAL INT"},
    {BlockKind::SFC, 126, "SYNC_PI", "IN PART BYTE RETURN RET_VAL INT OUT FLADDR WORD"},
    {BlockKind::SFC, 127, "SYNC_PO", "IN PART BYTE RETURN RET_VAL INT OUT FLADDR WORD"},
    {BlockKind::SFB, 19, "START",
     "IN REQ BOOL ID WORD " MERKER_SEND_DONE "INOUT PI_NAME ANY ARG ANY IO_STATE BYTE"},
    {BlockKind::SFB, 20, "STOP",
     "IN REQ BOOL ID WORD " MERKER_SEND_DONE "INOUT PI_NAME ANY IO_STATE BYTE"},
    {BlockKind::SFB, 33, "ALARM",
     "IN EN_R BOOL SIG BOOL ID WORD EV_ID DWORD SEVERITY WORD " MERKER_SEND_DONE
     "ACK_DN BOOL ACK_UP BOOL " MERKER_TEN_VALUES},
    {BlockKind::SFB, 36, "NOTIFY",
     "IN SIG BOOL ID WORD EV_ID DWORD SEVERITY WORD " MERKER_SEND_DONE MERKER_TEN_VALUES},
};

#undef MERKER_SEND_DONE
#undef MERKER_TEN_VALUES

constexpr std::pair<std::string_view, Section> kSectionWords[] = {{"IN", Section::Input},
                                                                  {"OUT", Section::Output},
                                                                  {"INOUT", Section::InOut},
                                                                  {"RETURN", Section::Return}};

std::string_view takeParameterWord(std::string_view& text) {
  text = trim(text);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

block::Block interfaceOf(const OtherFunction& row) {
  block::Block result;
  result.id = {row.kind, row.number};
  result.symbol = result.attributes.name = std::string(row.name);
  Section section = Section::Input;
  for (std::string_view rest = row.parameters; !trim(rest).empty();) {
    const std::string_view word = takeParameterWord(rest);
    bool begins = false;
    for (const auto& [name, which] : kSectionWords)
      if (name == word) section = which, begins = true;
    if (begins) continue;
    block::Variable variable;
    variable.name = std::string(word);
    variable.section = section;
    variable.type =
        block::elementaryType(typeFromName(takeParameterWord(rest)).value_or(TypeCode::Void));
    if (section == Section::Return) result.returnType = variable.type;
    result.variables.push_back(std::move(variable));
  }
  const BitAddress end = block::layOut(result.variables, 0, true);
  if (row.kind == BlockKind::SFB) result.instanceBytes = end / 8;
  return result;
}

}  // namespace

const block::Block* functionOfOtherCpu(BlockId id) {
  static const std::map<BlockId, block::Block> kBlocks = [] {
    std::map<BlockId, block::Block> blocks;
    for (const OtherFunction& row : kOtherFunctions)
      blocks.emplace(BlockId{row.kind, row.number}, interfaceOf(row));
    return blocks;
  }();
  const auto found = kBlocks.find(id);
  return found == kBlocks.end() ? nullptr : &found->second;
}

}  // namespace merker::step7
