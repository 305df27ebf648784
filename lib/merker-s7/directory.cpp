#include "directory.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <string>

#include "base/bytes.h"
#include "userdata.h"

namespace merker::s7client {
namespace {

using s7comm::Bytes;

constexpr int kBlocks = 3, kCounts = 1, kList = 2, kInformation = 3;
constexpr std::size_t kHead = 36, kEnd = 36;

struct Counter {
  int type;
  int TS7BlocksList::* count;
};
constexpr Counter kCounters[] = {
    {Block_OB, &TS7BlocksList::OBCount},   {Block_FB, &TS7BlocksList::FBCount},
    {Block_FC, &TS7BlocksList::FCCount},   {Block_SFB, &TS7BlocksList::SFBCount},
    {Block_SFC, &TS7BlocksList::SFCCount}, {Block_DB, &TS7BlocksList::DBCount},
    {Block_SDB, &TS7BlocksList::SDBCount}};

std::string twoDigits(int value) {
  return {static_cast<char>('0' + value / 10 % 10), static_cast<char>('0' + value % 10)};
}

// Days since 1984-01-01 as YYYY/MM/DD.
template <std::size_t size>
void writeDate(char (&text)[size], std::uint16_t days) {
  constexpr std::time_t kDay = 86'400, k1984 = 5'113 * kDay;
  const std::time_t time = k1984 + days * kDay;
  std::tm date{};
  gmtime_r(&time, &date);
  std::string words = std::to_string(date.tm_year + 1900) + '/' + twoDigits(date.tm_mon + 1) +
                      '/' + twoDigits(date.tm_mday);
  words.resize(size - 1);
  std::memcpy(text, words.c_str(), size);
}

template <std::size_t size>
void writeName(char (&text)[size], const std::uint8_t* name) {
  std::memcpy(text, name, size - 1);
  text[size - 1] = 0;
}

// docs/formats/block.md
void readHead(s7comm::View head, s7comm::View end, TS7BlockInfo& info) {
  info = {};
  info.BlkFlags = head[3];
  info.BlkLang = head[4];
  info.BlkType = head[5];
  info.BlkNumber = loadWord(&head[6]);
  info.LoadSize = static_cast<int>(loadDWord(&head[8]));
  info.SBBLength = loadWord(&head[28]);
  info.LocalData = loadWord(&head[32]);
  info.MC7Size = loadWord(&head[34]);
  writeDate(info.CodeDate, loadWord(&head[20]));
  writeDate(info.IntfDate, loadWord(&head[26]));
  writeName(info.Author, &end[0]);
  writeName(info.Family, &end[8]);
  writeName(info.Header, &end[16]);
  info.Version = end[24];
  info.CheckSum = loadWord(&end[26]);
}

}  // namespace

int listBlocks(Connection& connection, TS7BlocksList& counts) {
  constexpr std::size_t kRecord = 4;
  Bytes answer;
  if (const int error = askUserdata(connection, kBlocks, kCounts, {}, answer)) return error;
  counts = {};
  for (std::size_t at = 0; at + kRecord <= answer.size(); at += kRecord)
    for (const Counter& one : kCounters)
      if (answer[at + 1] == one.type) counts.*one.count = loadWord(&answer[at + 2]);
  return 0;
}

int listBlocksOfType(Connection& connection, int type, std::vector<std::uint16_t>& numbers) {
  constexpr std::size_t kRecord = 4;
  const std::uint8_t which[] = {'0', static_cast<std::uint8_t>(type)};
  Bytes answer;
  if (const int error = askUserdata(connection, kBlocks, kList, which, answer)) return error;
  for (std::size_t at = 0; at + kRecord <= answer.size(); at += kRecord)
    numbers.push_back(loadWord(&answer[at]));
  return 0;
}

int blockInfo(Connection& connection, const BlockNumber& block, TS7BlockInfo& info) {
  constexpr std::size_t kBefore = 6;
  if (!isBlock(block)) return errCliInvalidBlockNumber;
  const std::string name = blockName(block, 'A');
  const Bytes which(name.begin(), name.end());
  Bytes answer;
  if (const int error = askUserdata(connection, kBlocks, kInformation, which, answer)) return error;
  if (answer.size() < kBefore + kHead + kEnd) return errCliInvalidPlcAnswer;
  readHead(s7comm::View(answer).subspan(kBefore), s7comm::View(answer).subspan(kBefore + kHead),
           info);
  return 0;
}

bool readInfo(s7comm::View container, TS7BlockInfo& info) {
  const bool good = container.size() >= kHead + kEnd && container[0] == 0x70 &&
                    loadDWord(&container[8]) == container.size();
  if (good) readHead(container, container.last(kEnd), info);
  return good;
}

}  // namespace merker::s7client
