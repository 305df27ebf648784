#include "step7/operand_words.h"

#include "base/text.h"

namespace merker::step7 {
namespace {

constexpr MemoryWord kWords[] = {
    {"E", "I", Area::Input, Width::Bit},
    {"EB", "IB", Area::Input, Width::Byte},
    {"EW", "IW", Area::Input, Width::Word},
    {"ED", "ID", Area::Input, Width::DWord},
    {"A", "Q", Area::Output, Width::Bit},
    {"AB", "QB", Area::Output, Width::Byte},
    {"AW", "QW", Area::Output, Width::Word},
    {"AD", "QD", Area::Output, Width::DWord},
    {"M", "M", Area::Flag, Width::Bit},
    {"MB", "MB", Area::Flag, Width::Byte},
    {"MW", "MW", Area::Flag, Width::Word},
    {"MD", "MD", Area::Flag, Width::DWord},
    {"L", "L", Area::Local, Width::Bit},
    {"LB", "LB", Area::Local, Width::Byte},
    {"LW", "LW", Area::Local, Width::Word},
    {"LD", "LD", Area::Local, Width::DWord},
    {"DBX", "DBX", Area::DataBlock, Width::Bit},
    {"DBB", "DBB", Area::DataBlock, Width::Byte},
    {"DBW", "DBW", Area::DataBlock, Width::Word},
    {"DBD", "DBD", Area::DataBlock, Width::DWord},
    {"DIX", "DIX", Area::Instance, Width::Bit},
    {"DIB", "DIB", Area::Instance, Width::Byte},
    {"DIW", "DIW", Area::Instance, Width::Word},
    {"DID", "DID", Area::Instance, Width::DWord},
    {"PEB", "PIB", Area::Peripheral, Width::Byte},
    {"PEW", "PIW", Area::Peripheral, Width::Word},
    {"PED", "PID", Area::Peripheral, Width::DWord},
    {"PAB", "PQB", Area::Peripheral, Width::Byte, true},
    {"PAW", "PQW", Area::Peripheral, Width::Word, true},
    {"PAD", "PQD", Area::Peripheral, Width::DWord, true},
};

struct StatusWordRow {
  std::string_view de, en;
  mc7::StatusQuery query;
};
constexpr StatusWordRow kStatus[] = {
    {"OS", "OS", mc7::StatusQuery::OS},          {"OV", "OV", mc7::StatusQuery::OV},
    {">0", ">0", mc7::StatusQuery::Greater},     {"<0", "<0", mc7::StatusQuery::Less},
    {"UO", "UO", mc7::StatusQuery::Unordered},   {"<>0", "<>0", mc7::StatusQuery::NotEqual},
    {"==0", "==0", mc7::StatusQuery::Equal},     {">=0", ">=0", mc7::StatusQuery::GreaterEqual},
    {"<=0", "<=0", mc7::StatusQuery::LessEqual}, {"BIE", "BR", mc7::StatusQuery::BIE},
};

}  // namespace

const MemoryWord* findMemoryWord(std::string_view word, std::optional<Mnemonics>& which) {
  which.reset();
  for (const MemoryWord& row : kWords) {
    if (equalsIgnoreCase(word, row.de)) {
      if (row.de != row.en) which = Mnemonics::German;
      return &row;
    }
    if (equalsIgnoreCase(word, row.en)) {
      which = Mnemonics::International;
      return &row;
    }
  }
  return nullptr;
}

std::optional<mc7::StatusQuery> findStatusWord(std::string_view word,
                                               std::optional<Mnemonics>& which) {
  which.reset();
  for (const StatusWordRow& row : kStatus) {
    const bool german = equalsIgnoreCase(word, row.de);
    if (!german && !equalsIgnoreCase(word, row.en)) continue;
    if (row.de != row.en) which = german ? Mnemonics::German : Mnemonics::International;
    return row.query;
  }
  return std::nullopt;
}

std::optional<mc7::DataBlockQuery> findDataBlockQuery(std::string_view word) {
  using Query = mc7::DataBlockQuery;
  static constexpr std::pair<std::string_view, Query> kRows[] = {{"DBLG", Query::DbLength},
                                                                 {"DILG", Query::DiLength},
                                                                 {"DBNO", Query::DbNumber},
                                                                 {"DINO", Query::DiNumber}};
  for (const auto& [name, query] : kRows)
    if (equalsIgnoreCase(word, name)) return query;
  return std::nullopt;
}

}  // namespace merker::step7
