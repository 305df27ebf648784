#include "system.h"

#include <algorithm>
#include <cstring>

#include "base/bytes.h"
#include "userdata.h"

namespace merker::s7client {
namespace {

using s7comm::Bytes;

constexpr int kCpu = 4, kReadList = 1, kSecurity = 5, kEnter = 1, kClear = 2, kClock = 7,
              kReadClock = 1, kSetClock = 2;

// One record of at least so many bytes behind its index.
int readRecord(Connection& connection, int number, int index, std::size_t least, Bytes& record) {
  SystemList list;
  if (const int error = readList(connection, number, index, list)) return error;
  if (list.data.size() < least) return errCliInvalidPlcAnswer;
  record = std::move(list.data);
  return 0;
}

// Characters up to the first zero, without blanks behind them.
template <std::size_t size>
void copyText(char (&to)[size], s7comm::View from) {
  std::string text(from.begin(), std::find(from.begin(), from.end(), 0));
  text.erase(text.find_last_not_of(' ') + 1);
  text.resize(size - 1);
  std::memcpy(to, text.c_str(), size);
}

std::uint8_t bcd(int value) { return static_cast<std::uint8_t>(value / 10 % 10 << 4 | value % 10); }
int fromBcd(std::uint8_t value) { return (value >> 4) * 10 + (value & 0x0F); }

}  // namespace

int readList(Connection& connection, int number, int index, SystemList& list) {
  constexpr std::size_t kListHead = 8;
  Bytes which, answer;
  appendWord(which, static_cast<std::uint32_t>(number));
  appendWord(which, static_cast<std::uint32_t>(index));
  if (const int error = askUserdata(connection, kCpu, kReadList, which, answer)) return error;
  if (answer.size() < kListHead) return errCliInvalidPlcAnswer;
  list = {loadWord(&answer[4]), loadWord(&answer[6]), {answer.begin() + kListHead, answer.end()}};
  return 0;
}

// The first record has the order number, the last one ends with the version.
int orderCode(Connection& connection, TS7OrderCode& code) {
  constexpr std::size_t kNumberAt = 2, kCharacters = 20;
  Bytes record;
  if (const int error = readRecord(connection, 0x0011, 0, 28, record)) return error;
  code = {};
  copyText(code.Code, s7comm::View(record).subspan(kNumberAt, kCharacters));
  code.V1 = record[record.size() - 3];
  code.V2 = record[record.size() - 2];
  code.V3 = record[record.size() - 1];
  return 0;
}

int cpuInfo(Connection& connection, TS7CpuInfo& info) {
  constexpr std::size_t kRecord = 34, kCharacters = 32;
  SystemList list;
  if (const int error = readList(connection, 0x001C, 0, list)) return error;
  info = {};
  for (std::size_t at = 0; at + kRecord <= list.data.size(); at += kRecord) {
    const auto text = s7comm::View(list.data).subspan(at + 2, kCharacters);
    switch (loadWord(&list.data[at])) {
      case 1: copyText(info.ASName, text); break;
      case 2: copyText(info.ModuleName, text); break;
      case 4: copyText(info.Copyright, text); break;
      case 5: copyText(info.SerialNumber, text); break;
      case 7: copyText(info.ModuleTypeName, text); break;
      default: break;
    }
  }
  return 0;
}

int cpInfo(Connection& connection, TS7CpInfo& info) {
  Bytes record;
  if (const int error = readRecord(connection, 0x0131, 1, 14, record)) return error;
  info = {loadWord(&record[2]), loadWord(&record[4]), static_cast<int>(loadDWord(&record[6])),
          static_cast<int>(loadDWord(&record[10]))};
  return 0;
}

int protection(Connection& connection, TS7Protection& levels) {
  Bytes record;
  if (const int error = readRecord(connection, 0x0232, 4, 12, record)) return error;
  levels = {loadWord(&record[2]), loadWord(&record[4]), loadWord(&record[6]), loadWord(&record[8]),
            loadWord(&record[10])};
  return 0;
}

int plcStatus(Connection& connection, int& status) {
  constexpr std::size_t kModeAt = 3;
  Bytes record;
  if (const int error = readRecord(connection, 0x0424, 0, kModeAt + 1, record)) return error;
  status = record[kModeAt] == 0 || record[kModeAt] == S7CpuStatusRun ? record[kModeAt] : +S7CpuStatusStop;
  return 0;
}

// 00 19, then DATE_AND_TIME; 90 to 99 are of the last century.
int readClock(Connection& connection, std::tm& time) {
  constexpr std::size_t kTimeAt = 2, kOctets = 10;
  Bytes answer;
  if (const int error = askUserdata(connection, kClock, kReadClock, {}, answer)) return error;
  if (answer.size() < kOctets) return errCliInvalidPlcAnswer;
  const std::uint8_t* const t = &answer[kTimeAt];
  time = {};
  time.tm_year = fromBcd(t[0]) + (fromBcd(t[0]) < 90 ? 100 : 0);
  time.tm_mon = fromBcd(t[1]) - 1;
  time.tm_mday = fromBcd(t[2]);
  time.tm_hour = fromBcd(t[3]);
  time.tm_min = fromBcd(t[4]);
  time.tm_sec = fromBcd(t[5]);
  time.tm_wday = (t[7] & 0x0F) - 1;
  return 0;
}

int setClock(Connection& connection, const std::tm& time) {
  const Bytes octets = {0,
                        0x19,
                        bcd(time.tm_year % 100),
                        bcd(time.tm_mon + 1),
                        bcd(time.tm_mday),
                        bcd(time.tm_hour),
                        bcd(time.tm_min),
                        bcd(time.tm_sec),
                        0,
                        static_cast<std::uint8_t>(time.tm_wday + 1)};
  Bytes answer;
  return askUserdata(connection, kClock, kSetClock, octets, answer);
}

// 8 characters, each changed by the one two places before.
int enterPassword(Connection& connection, std::string_view password) {
  constexpr std::size_t kLength = 8;
  if (password.size() > kLength) return errCliInvalidParams;
  Bytes coded;
  for (std::size_t i = 0; i < kLength; ++i) {
    const auto character = static_cast<std::uint8_t>(i < password.size() ? password[i] : ' ');
    coded.push_back(static_cast<std::uint8_t>(character ^ 0x55 ^ (i < 2 ? 0 : coded[i - 2])));
  }
  Bytes answer;
  return askUserdata(connection, kSecurity, kEnter, coded, answer);
}

int clearPassword(Connection& connection) {
  Bytes answer;
  return askUserdata(connection, kSecurity, kClear, {}, answer);
}

}  // namespace merker::s7client
