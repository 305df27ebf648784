// What a GSD file says of a PROFIBUS-DP slave (EN 50170, GSD revisions 1 to 5).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace merker::gsd {

using Bytes = std::vector<std::uint8_t>;
// "0-3,5": from and to; both the same for a single number.
using Ranges = std::vector<std::pair<std::int64_t, std::int64_t>>;

// ExtUserPrmData: a parameter, the bits it has in a byte or a number of one to four bytes.
struct Parameter {
  std::int64_t number = 0;
  std::string name{}, type{};  // "Bit", "BitArea", "Unsigned16" … as written
  std::uint32_t firstBit = 0, lastBit = 7;
  std::int64_t standard = 0;
  Ranges allowed{};
  std::optional<std::int64_t> text{};  // PrmText
  std::uint32_t line = 0;
};

// User parameters of the device or of a module: bytes that are fixed, and parameters at a byte.
struct UserParameters {
  std::uint32_t length = 0;
  struct Fixed {
    std::uint32_t offset = 0;
    Bytes bytes;
  };
  struct Reference {
    std::uint32_t offset = 0;
    std::int64_t parameter = 0;
  };
  std::vector<Fixed> fixed;
  std::vector<Reference> references;
};

struct Module {
  std::string name{};
  Bytes configuration{};  // identifiers, in the order of the configuration telegram
  std::optional<std::int64_t> reference{};
  std::string info{};
  bool preset = false;
  UserParameters parameters{};
  std::uint32_t line = 0;
};

// SlotDefinition: the modules that may be plugged there, by their references.
struct Slot {
  std::int64_t number = 0;
  std::string name;
  std::optional<std::int64_t> standard{};
  Ranges allowed;
};

struct BaudRate {
  std::string name;       // "1.5M"
  std::int64_t rate = 0;  // bit/s
  bool supported = false;
  std::int64_t maxTsdr = 0;  // bit times until it answers at the latest; 0: not said
};

// Bits of the device-related diagnosis.
struct DiagnosisText {
  std::uint32_t firstBit = 0, lastBit = 0;
  std::optional<std::int64_t> value{};  // of an area
  std::string text;
};

struct Device {
  std::string vendor, model, revision, order, hardware, software, info, family;
  std::int64_t gsdRevision = 0, ident = 0, stationType = 0, maxModules = 0, maxInput = 0,
               maxOutput = 0, maxData = 0, maxDiagnosis = 0, firstSlot = 0, minInterval = 0,
               parameterLength = 0, maxParameterLength = 0;
  bool modular = false, sync = false, freeze = false, autoBaud = false, failSafe = false,
       dpv1 = false, fixedModules = false;
  std::vector<BaudRate> rates;
  UserParameters parameters;
  std::vector<Module> modules;
  std::vector<Slot> slots;
  std::vector<Parameter> definitions;
  std::map<std::int64_t, std::map<std::int64_t, std::string>> texts;
  std::vector<DiagnosisText> diagnosis;
  // Everything else that is written "Keyword = value", as it stands there.
  std::map<std::string, std::string> others;
};

}  // namespace merker::gsd
