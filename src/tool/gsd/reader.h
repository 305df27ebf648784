// Statement by statement into a Device: which keyword means what depends on the section that is
// open.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gsd/read.h"

namespace merker::gsd {

std::vector<BaudRate> knownRates();

// What stands between Module and EndModule and the like.
enum class Section : std::uint8_t { None, Texts, Definition, Module, Slots, Other };
class Reader {
 public:
  Reader(const source::SourceFile& file, Reading& reading)
      : file_(file), reading_(reading), device_(reading.device) {
    device_.rates = knownRates();
  }

  void read(const Statement& statement);
  void finish();

 private:
  using Handler = void (Reader::*)(const Statement&);
  struct Row {
    Section section;
    std::string_view keyword;
    Handler handler;
  };

  void remark(std::size_t offset, std::string text) {
    reading_.remarks.push_back(remarkAt(file_, offset, std::move(text)));
  }
  std::uint32_t lineOf(const Statement& s) const { return file_.position(s.offset).line; }
  // The number in it; a remark if there is none.
  std::optional<std::int64_t> wanted(const Statement& s);
  std::uint32_t index(const Statement& s) const;
  bool opens(const Statement& s, std::string_view keyword);
  bool ends(const Statement& s, std::string_view keyword);
  void closeOpen();
  void begin(Section section, const Statement& s);
  bool inSection(const Statement& s, std::string_view keyword);
  bool inDevice(const Statement& s, std::string_view keyword);
  bool rate(const Statement& s, std::string_view keyword);
  void checkReferences(const UserParameters& used, std::uint32_t line);

  void text(const Statement& s);
  void textOfParameter(const Statement& s);
  void parameterType(const Statement& s);
  void bareNumber(const Statement& s);
  void moduleInfo(const Statement& s);
  void modulePreset(const Statement& s);
  void moduleLength(const Statement& s);
  void slot(const Statement& s);
  void fixed(const Statement& s);
  void reference(const Statement& s);
  void userData(const Statement& s);
  void diagnosisBit(const Statement& s);
  void diagnosisArea(const Statement& s);
  void diagnosisValue(const Statement& s);

  UserParameters& parameters() {
    return open_ == Section::Module ? device_.modules.back().parameters : device_.parameters;
  }

  const source::SourceFile& file_;
  Reading& reading_;
  Device& device_;
  Section open_ = Section::None;
  std::size_t openRow_ = 0, openedAt_ = 0;
  std::int64_t texts_ = 0;                                       // PrmText that is open
  std::optional<std::pair<std::int64_t, std::int64_t>> area_{};  // Unit_Diag_Area that is open
};

}  // namespace merker::gsd
