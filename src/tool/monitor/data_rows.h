// The values of a data block: variable by variable, word by word; also as rows of machine code.
#pragma once

#include <span>

#include "monitor/machine_code.h"

namespace merker::monitor {

struct DataValue {
  std::uint32_t byte = 0, bit = 0;  // where it begins; of STEP 5 `byte` counts words
  std::uint32_t bytes = 0;          // length
  std::string place{};              // "DBX 4.3", "DW 6"
  std::string path{};               // "Setpoint[2].Speed"; of STEP 5 empty
  std::string type{};               // "INT"; of STEP 5 the format: "KF"
  std::string section{};            // "IN", "OUT", "IN_OUT", "STAT" of an instance; else empty
  std::string comment{};
  std::string code{};               // bytes or words in hex
  std::string initial{}, actual{};  // as constants; STEP 5 has no initial values
};

struct DataValues {
  std::vector<DataValue> values;
  std::size_t more = 0;  // variables beyond the first 20,000
};

// The variables, with these bytes as their actual values.
DataValues dataValues(const block::Block& block, std::span<const std::uint8_t> actual);
DataValues dataValues(const mc5::Block& block);
// The temporary variables, with these local data of the block.
DataValues localValues(const block::Block& block, std::span<const std::uint8_t> local);

// The variables with the values that they begin with and have; what no variable names in hex.
std::vector<MachineCodeRow> dataRows(const block::Block& block);
// Each word in the format of its declaration.
std::vector<MachineCodeRow> dataRows(const mc5::Block& block);

}  // namespace merker::monitor
