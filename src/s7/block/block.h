// A compiled block as the CPU holds it: machine code, interface, attributes. The compiled block is
// the program (docs/architecture.md, decision 1); source text is a view of it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "address/block_id.h"
#include "block/type.h"
#include "check/check.h"

namespace merker::block {

// Where an instruction comes from; entries ascend by offset and hold until the next one.
struct LineEntry {
  std::uint32_t offset = 0;  // bytes of code
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

enum class Language : std::uint8_t {
  Awl = 1,
  Kop = 2,
  Fup = 3,
  Scl = 4,
  Db = 5,
  Graph = 6,
  Sdb = 7,
  CpuDb = 8
};

struct Attributes {
  std::string title, comment, author, family, name;
  std::uint8_t version = 0x01;  // high nibble.low nibble: 0.1
  bool knowHowProtect = false;
  bool readOnly = false, unlinked = false, nonRetain = false;  // DB
  bool codeVersion1 = false;                                // FB: not capable of multiple instances
  std::vector<std::pair<std::string, std::string>> system;  // { S7_m_c := 'true' }
  // As a container had them: the security word, and when code and interface were changed.
  std::uint32_t security = 0;
  std::array<std::uint8_t, 12> changed{};
};

struct Network {
  std::uint32_t offset = 0;
  std::string title;
};

struct Block {
  BlockId id;
  std::string symbol;  // symbolic name, if any
  Attributes attributes;
  Language language = Language::Awl;

  // Interface: IN, OUT, IN_OUT, RETURN, STAT, TEMP with addresses. Of an FC, parameters have
  // addresses only for display; their order (IN, RETURN, OUT, IN_OUT) is the order of the parameter
  // list.
  std::vector<Variable> variables;
  TypePtr returnType;  // FC; null = VOID
  std::uint32_t localBytes =
      0;  // local data requirement, with the transfer area of calls (S7-PAR-12)
  std::uint32_t instanceBytes = 0;  // FB: length of an instance

  std::vector<std::uint8_t> code;  // MC7; empty for DB, UDT
  std::vector<Network> networks;
  std::vector<std::uint32_t>
      jumps;  // places of the jumps in words (mc7::jumpPositions), for the segment table
  std::string file;
  std::vector<LineEntry> lines;
  std::vector<std::string> labels;
  std::vector<Check> checks;

  // DB: start values as declared and actual values as downloaded (S7-MEM-04).
  std::vector<std::uint8_t> initialData, actualData;
  std::int32_t instanceOf = -1;  // DB: number of the FB or SFB it is an instance of, else -1
  bool instanceOfSystemBlock = false;

  std::uint32_t line(std::uint32_t offset) const;
};

// The blocks of one CPU, ready to load. Same kind and number only once.
using Program = std::map<BlockId, Block>;

// Parameters of an FC in the order of its parameter list (IN, RETURN, OUT, IN_OUT).
std::vector<const Variable*> parameters(const Block& block);

}  // namespace merker::block
