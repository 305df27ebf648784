// Keywords that are one value of the device.
#include <array>

#include "base/text.h"
#include "gsd/reader.h"
#include "gsd/values.h"

namespace merker::gsd {
namespace {

struct RateRow {
  std::string_view name;
  std::int64_t rate;
};
constexpr std::array<RateRow, 11> kRates{{{"9.6", 9'600},
                                          {"19.2", 19'200},
                                          {"31.25", 31'250},
                                          {"45.45", 45'450},
                                          {"93.75", 93'750},
                                          {"187.5", 187'500},
                                          {"500", 500'000},
                                          {"1.5M", 1'500'000},
                                          {"3M", 3'000'000},
                                          {"6M", 6'000'000},
                                          {"12M", 12'000'000}}};

template <typename T>
struct Field {
  std::string_view keyword;
  T Device::*member;
};
constexpr std::array<Field<std::string>, 8> kTexts{{{"VENDOR_NAME", &Device::vendor},
                                                    {"MODEL_NAME", &Device::model},
                                                    {"REVISION", &Device::revision},
                                                    {"ORDERNUMBER", &Device::order},
                                                    {"HARDWARE_RELEASE", &Device::hardware},
                                                    {"SOFTWARE_RELEASE", &Device::software},
                                                    {"INFO_TEXT", &Device::info},
                                                    {"SLAVE_FAMILY", &Device::family}}};
constexpr std::array<Field<std::int64_t>, 12> kNumbers{
    {{"GSD_REVISION", &Device::gsdRevision},
     {"IDENT_NUMBER", &Device::ident},
     {"STATION_TYPE", &Device::stationType},
     {"MAX_MODULE", &Device::maxModules},
     {"MAX_INPUT_LEN", &Device::maxInput},
     {"MAX_OUTPUT_LEN", &Device::maxOutput},
     {"MAX_DATA_LEN", &Device::maxData},
     {"MAX_DIAG_DATA_LEN", &Device::maxDiagnosis},
     {"MODUL_OFFSET", &Device::firstSlot},
     {"MIN_SLAVE_INTERVALL", &Device::minInterval},
     {"USER_PRM_DATA_LEN", &Device::parameterLength},
     {"MAX_USER_PRM_DATA_LEN", &Device::maxParameterLength}}};
constexpr std::array<Field<bool>, 7> kFlags{{{"MODULAR_STATION", &Device::modular},
                                             {"SYNC_MODE_SUPP", &Device::sync},
                                             {"FREEZE_MODE_SUPP", &Device::freeze},
                                             {"AUTO_BAUD_SUPP", &Device::autoBaud},
                                             {"FAIL_SAFE", &Device::failSafe},
                                             {"DPV1_SLAVE", &Device::dpv1},
                                             {"FIXPRESETMODULES", &Device::fixedModules}}};

}  // namespace

std::vector<BaudRate> knownRates() {
  std::vector<BaudRate> rates;
  for (const RateRow& row : kRates)
    rates.push_back({.name = std::string(row.name), .rate = row.rate});
  return rates;
}

bool Reader::rate(const Statement& s, std::string_view keyword) {
  for (BaudRate& rate : device_.rates) {
    const std::string name = upper(rate.name);
    if (keyword == name + "_SUPP") return rate.supported = wanted(s).value_or(0) != 0, true;
    if (keyword == "MAXTSDR_" + name) return rate.maxTsdr = wanted(s).value_or(0), true;
  }
  return false;
}

bool Reader::inDevice(const Statement& s, std::string_view keyword) {
  for (const auto& row : kTexts)
    if (row.keyword == keyword) return device_.*row.member = firstText(s), true;
  for (const auto& row : kNumbers)
    if (row.keyword == keyword) return device_.*row.member = wanted(s).value_or(0), true;
  for (const auto& row : kFlags)
    if (row.keyword == keyword) return device_.*row.member = wanted(s).value_or(0) != 0, true;
  return rate(s, keyword);
}

}  // namespace merker::gsd
