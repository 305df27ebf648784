// A small STEP 7 project as files, written by the format (docs/formats/s7p.md), for tests.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "block/block.h"
#include "block/container.h"
#include "block/interface_part.h"
#include "block/segment_table.h"

namespace merker::s7p_files {

using Row = std::map<std::string, std::string>;

inline std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i & 0xFF);
  return out;
}

struct Column {
  std::string name;
  char type;
  std::size_t length;
};

// A .DBF: texts fill their field with blanks on the right, numbers on the left.
inline std::string table(const std::vector<Column>& columns, const std::vector<Row>& rows,
                         bool memo = false, const std::vector<std::size_t>& deleted = {}) {
  std::size_t length = 1;
  for (const Column& c : columns) length += c.length;
  std::string out = memo ? "\x8B" : "\x03";
  out += std::string("\x18\x01\x01", 3) + little(rows.size(), 4) +
         little(32 + 32 * columns.size() + 1, 2) + little(length, 2) + std::string(20, '\0');
  for (const Column& c : columns) {
    std::string name = c.name;
    name.resize(11, '\0');
    out +=
        name + c.type + std::string(4, '\0') + static_cast<char>(c.length) + std::string(15, '\0');
  }
  out += '\r';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += std::find(deleted.begin(), deleted.end(), i) == deleted.end() ? ' ' : '*';
    for (const Column& c : columns) {
      const auto found = rows[i].find(c.name);
      std::string value = (found == rows[i].end() ? "" : found->second).substr(0, c.length);
      const std::string fill(c.length - value.size(), ' ');
      out += c.type == 'C' ? value + fill : fill + value;
    }
  }
  return out + '\x1A';
}

// A .DBT of 512-byte blocks.
class Memo {
 public:
  Memo() : bytes_(512, '\0') { bytes_.replace(20, 2, little(512, 2)); }
  std::string add(const std::string& content) {
    if (content.empty()) return "";
    const std::string number = std::to_string(bytes_.size() / 512);
    bytes_ += std::string("\xFF\xFF\x08\x00", 4) + little(content.size() + 8, 4) + content;
    bytes_.resize((bytes_.size() + 511) / 512 * 512, '\x5A');  // rubbish of earlier contents
    return number;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

inline std::string text(const std::vector<std::uint8_t>& bytes) {
  return std::string(bytes.begin(), bytes.end());
}

struct StatementComment {
  int goOn;
  int flags;
  std::string text;
};
struct NetworkTexts {
  std::string title, comment;
  std::vector<StatementComment> statements;
};

// SUBBLK.DBF and its memo.
class BlockFolder {
 public:
  struct Extra {
    std::string declaration, title, comment;
    std::vector<NetworkTexts> networks;
    int language = 1, attribute = 1, password = 0;
    bool wrongChecksum = false;
  };

  void add(const block::Block& block) { add(block, Extra()); }
  void add(const block::Block& block, const Extra& extra) {
    ++object_;
    const Parts parts = partsOf(block.id.kind);
    const bool data = block.id.kind == BlockKind::DB;
    const std::string code = text(data ? block.actualData : block.code);
    const std::string interface = text(block::writeInterface(block));
    const std::string networks = data ? "" : text(block::writeSegmentTable(block));
    Row row = start(parts.code, block, extra);
    const unsigned sum = block::checksum(block);
    put(row, "MC5CODE", "MC5LEN", code);
    put(row, "SSBPART", "SSBLEN", interface);
    put(row, "ADDINFO", "ADDLEN", networks);
    row["LOCDATALEN"] = std::to_string(block.localBytes);
    row["CHECKSUM"] = std::to_string(extra.wrongChecksum ? 1 : (sum & 0xFF) << 8 | sum >> 8);
    row["VERSION"] = std::to_string(block.attributes.version);
    row["USERNAME"] = block.attributes.author;
    row["TIMESTAMP1"] = std::string("\x00\x00\x03\xE8\x00\x01", 6);  // 1 s of 1984-01-02
    rows_.push_back(row);
    if (!extra.declaration.empty()) {
      Row declaration = start(parts.text, block, extra);
      put(declaration, "MC5CODE", "MC5LEN", extra.declaration + std::string(3, '\0'));
      rows_.push_back(declaration);
    }
    if (!extra.networks.empty() || !extra.title.empty()) addComments(parts.comments, block, extra);
  }
  void addText(int type, int number, const std::string& content, const std::string& more = "") {
    ++object_;
    Row row{{"OBJECTID", std::to_string(object_)},
            {"BLKLANG", "00001"},
            {"SUBBLKTYP", fmt::format("{:05}", type)},
            {"BLKNUMBER", fmt::format("{:05}", number)}};
    put(row, "MC5CODE", "MC5LEN", content);
    put(row, "ADDINFO", "ADDLEN", more);
    rows_.push_back(row);
  }
  void deleteLast() { deleted_.push_back(rows_.size() - 1); }

  std::string dbf() const {
    return table({{"OBJECTID", 'N', 11},
                  {"BLKLANG", 'C', 5},
                  {"SUBBLKTYP", 'C', 5},
                  {"BLKNUMBER", 'C', 5},
                  {"ATTRIBUTE", 'N', 3},
                  {"MC5LEN", 'N', 11},
                  {"SSBLEN", 'N', 11},
                  {"ADDLEN", 'N', 11},
                  {"LOCDATALEN", 'N', 5},
                  {"TIMESTAMP1", 'C', 6},
                  {"PASSWORD", 'N', 11},
                  {"USERNAME", 'C', 8},
                  {"BLOCKFNAME", 'C', 8},
                  {"BLOCKNAME", 'C', 8},
                  {"VERSION", 'N', 3},
                  {"CHECKSUM", 'N', 5},
                  {"MC5CODE", 'M', 10},
                  {"SSBPART", 'M', 10},
                  {"ADDINFO", 'M', 10}},
                 rows_, true, deleted_);
  }
  const std::string& dbt() const { return memo_.bytes(); }

 private:
  struct Parts {
    int code, text, comments;
  };
  static Parts partsOf(BlockKind kind) {
    switch (kind) {
      case BlockKind::OB:
        return {8, 3, 17};
      case BlockKind::FC:
        return {12, 5, 19};
      case BlockKind::FB:
        return {14, 4, 18};
      case BlockKind::SFC:
        return {13, 7, 22};
      case BlockKind::SFB:
        return {15, 9, 21};
      default:
        return {10, 6, 20};
    }
  }
  Row start(int type, const block::Block& block, const Extra& extra) const {
    return {{"OBJECTID", std::to_string(object_)},
            {"BLKLANG", fmt::format("{:05}", extra.language)},
            {"SUBBLKTYP", fmt::format("{:05}", type)},
            {"BLKNUMBER", fmt::format("{:05}", block.id.number)},
            {"ATTRIBUTE", std::to_string(extra.attribute)},
            {"PASSWORD", std::to_string(extra.password)}};
  }
  void put(Row& row, const char* column, const char* length, const std::string& content) {
    row[column] = memo_.add(content);
    row[length] = std::to_string(content.size());
  }
  void addComments(int type, const block::Block& block, const Extra& extra) {
    Row row = start(type, block, extra);
    const std::string head = extra.title + '\0';
    put(row, "SSBPART", "SSBLEN",
        '\x03' + little(3 + head.size(), 2) + head + extra.comment + '\0');
    std::string lengths = little(extra.networks.size(), 2), all;
    for (const NetworkTexts& n : extra.networks) {
      const std::size_t comment = 6 + n.title.size() + 1, end = comment + n.comment.size() + 1;
      std::string entry = '\x06' + little(comment, 2) + little(end, 2) + '\x06';
      entry += n.title + '\0' + n.comment + '\0';
      for (const StatementComment& s : n.statements)
        entry += little(s.text.size(), 2) + little(static_cast<unsigned>(s.goOn), 2) +
                 static_cast<char>(s.flags) + '\x28' + s.text;
      lengths += little(entry.size(), 2);
      all += entry;
    }
    put(row, "ADDINFO", "ADDLEN", lengths);
    put(row, "MC5CODE", "MC5LEN", all);
    rows_.push_back(row);
  }

  Memo memo_;
  std::vector<Row> rows_;
  std::vector<std::size_t> deleted_;
  int object_ = 0;
};

using Files = std::map<std::string, std::string>;  // path to bytes

// A page of linkhrs.lnk at `offset` with direct links.
inline std::string linkPage(std::uint32_t offset,
                            const std::vector<std::array<std::uint32_t, 3>>& links) {
  std::string page = little(offset, 4) + little(0, 4) + little(links.size(), 4) + little(0, 4);
  for (const auto& [type, id, relation] : links)
    page += little(0, 8) + little(type, 4) + little(id, 4) + little(relation, 4) + little(0, 4);
  page.resize(512, '\0');
  return page;
}

inline std::string programs(const std::vector<Row>& rows) {
  return table({{"ID", 'N', 11}, {"NAME", 'C', 24}, {"RSRVD4_L", 'N', 11}}, rows);
}

inline std::string symbols(const std::vector<Row>& rows,
                           const std::vector<std::size_t>& deleted = {}) {
  return table({{"_SKZ", 'C', 24},
                {"_OPIEC", 'C', 12},
                {"_OPHIST", 'C', 12},
                {"_DATATYP", 'C', 10},
                {"_COMMENT", 'C', 80}},
               rows, false, deleted);
}

// One program with blocks, symbols and sources in folders of mixed case.
struct Project {
  BlockFolder blocks;
  std::vector<Row> symbolRows;
  std::vector<std::pair<std::string, std::string>> sources;  // name, text; AWL
  std::string page = "1252";

  Files files() const {
    Files files;
    const std::string name = "Plant";
    files["Plant.s7p"] = little(0, 4) + static_cast<char>(name.size()) + name + little(0, 4);
    files["Global/Language"] = "0\r\n1031\r\n204\r\n" + page + "\r\n850\r\n";
    files["hrs/S7RESOFF.DBF"] =
        programs({{{"ID", "1"}, {"NAME", "S7 Program(1)"}, {"RSRVD4_L", "512"}}});
    files["hrs/linkhrs.lnk"] =
        std::string(512, '\0') +
        linkPage(512, {{0x116001, 10, 30}, {0x113001, 27, 24}, {0x112004, 1, 98}});
    files["ombstx/offline/0000000a/SUBBLK.DBF"] = blocks.dbf();
    files["ombstx/offline/0000000A/subblk.dbt"] = blocks.dbt();
    files["YDBs/27/SYMLIST.DBF"] = symbols(symbolRows);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const std::string file = std::to_string(i + 1) + ".AWL";
      rows.push_back({{"NAME", sources[i].first}, {"FILENAME", file}, {"TYPE", "1122309"}});
      files["s7asrcom/00000001/" + file] = sources[i].second;
    }
    files["S7ASRCOM/00000001/S7CONTAI.DBF"] =
        table({{"TYPE", 'N', 11}, {"NAME", 'C', 24}, {"FILENAME", 'C', 12}}, rows);
    return files;
  }
};

}  // namespace merker::s7p_files
