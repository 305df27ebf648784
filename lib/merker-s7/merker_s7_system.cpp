// The C side of what tells of the CPU: its blocks, its status, its clock.
#include <algorithm>
#include <cstring>

#include "base/bytes.h"
#include "client.h"
#include "directory.h"
#include "system.h"
#include "variables.h"

using namespace merker::s7client;

namespace {

// One value that is fetched over the connection.
template <typename Value>
int told(S7Object object, Value* value, int (*ask)(Connection&, Value&)) {
  if (value == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) { return ask(client.connection, *value); });
}

int valuesLength(Connection& connection, int db, int& length) {
  TS7BlockInfo info;
  if (const int error = blockInfo(connection, {Block_DB, db}, info)) return error;
  length = info.MC7Size;
  return 0;
}

int readAll(Connection& connection, int db, std::uint8_t* data, int* size) {
  int length = 0;
  if (const int error = valuesLength(connection, db, length)) return error;
  if (*size < length) return errCliBufferTooSmall;
  *size = length;
  return read(connection, {S7AreaDB, db, 0, length, S7WLByte}, data);
}

int fill(Connection& connection, int db, int value) {
  int length = 0;
  if (const int error = valuesLength(connection, db, length)) return error;
  const merker::s7comm::Bytes bytes(static_cast<std::size_t>(length),
                                    static_cast<std::uint8_t>(value));
  return write(connection, {S7AreaDB, db, 0, length, S7WLByte}, bytes.data());
}

int takeList(const SystemList& list, TS7SZL* to, int* size) {
  constexpr std::size_t kHead = sizeof(SZL_HEADER);
  const std::size_t needed = kHead + list.data.size();
  if (static_cast<std::size_t>(*size) < needed) return errCliBufferTooSmall;
  to->Header = {list.recordLength, list.records};
  std::memcpy(to->Data, list.data.data(), list.data.size());
  *size = static_cast<int>(needed);
  return 0;
}

int takeNumbers(const SystemList& list, TS7SZLList* to, int* count) {
  const std::size_t all = list.data.size() / 2;
  if (static_cast<std::size_t>(*count) < all) return errCliBufferTooSmall;
  to->Header = {list.recordLength, list.records};
  for (std::size_t i = 0; i < all; ++i) to->List[i] = merker::loadWord(&list.data[2 * i]);
  *count = static_cast<int>(all);
  return 0;
}

}  // namespace

int Cli_ListBlocks(S7Object object, TS7BlocksList* counts) {
  return told(object, counts, listBlocks);
}

int Cli_ListBlocksOfType(S7Object object, int type, TS7BlocksOfType* numbers, int* count) {
  if (numbers == nullptr || count == nullptr || *count < 0) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    std::vector<std::uint16_t> all;
    if (const int error = listBlocksOfType(client.connection, type, all)) return error;
    *count = std::min(*count, static_cast<int>(all.size()));
    std::copy_n(all.begin(), *count, *numbers);
    return 0;
  });
}

int Cli_GetAgBlockInfo(S7Object object, int type, int number, TS7BlockInfo* info) {
  if (info == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return blockInfo(client.connection, {type, number}, *info);
  });
}

int Cli_GetPgBlockInfo(S7Object object, void* block, TS7BlockInfo* info, int size) {
  if (block == nullptr || info == nullptr || size < 0) return errCliInvalidParams;
  const auto* const bytes = static_cast<const std::uint8_t*>(block);
  return with(object, [&](Client&) {
    const bool good = readInfo({bytes, static_cast<std::size_t>(size)}, *info);
    return good ? 0 : static_cast<int>(errCliInvalidBlockSize);
  });
}

int Cli_DBGet(S7Object object, int db, void* data, int* size) {
  if (data == nullptr || size == nullptr || *size < 0) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    return readAll(client.connection, db, static_cast<std::uint8_t*>(data), size);
  });
}
int Cli_DBFill(S7Object object, int db, int value) {
  return with(object, [&](Client& client) { return fill(client.connection, db, value); });
}

int Cli_ReadSZL(S7Object object, int number, int index, TS7SZL* list, int* size) {
  if (list == nullptr || size == nullptr || *size < 0) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    SystemList found;
    const int error = readList(client.connection, number, index, found);
    return error != 0 ? error : takeList(found, list, size);
  });
}
int Cli_ReadSZLList(S7Object object, TS7SZLList* list, int* count) {
  if (list == nullptr || count == nullptr || *count < 0) return errCliInvalidParams;
  return with(object, [&](Client& client) {
    SystemList found;
    const int error = readList(client.connection, 0, 0, found);
    return error != 0 ? error : takeNumbers(found, list, count);
  });
}

int Cli_GetOrderCode(S7Object object, TS7OrderCode* code) { return told(object, code, orderCode); }
int Cli_GetCpuInfo(S7Object object, TS7CpuInfo* info) { return told(object, info, cpuInfo); }
int Cli_GetCpInfo(S7Object object, TS7CpInfo* info) { return told(object, info, cpInfo); }
int Cli_GetProtection(S7Object object, TS7Protection* levels) {
  return told(object, levels, protection);
}
int Cli_GetPlcStatus(S7Object object, int* status) { return told(object, status, plcStatus); }

int Cli_GetPlcDateTime(S7Object object, struct tm* time) { return told(object, time, readClock); }
int Cli_SetPlcDateTime(S7Object object, struct tm* time) {
  if (time == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) { return setClock(client.connection, *time); });
}
int Cli_SetPlcSystemDateTime(S7Object object) {
  const std::time_t now = std::time(nullptr);
  std::tm here{};
  localtime_r(&now, &here);
  return Cli_SetPlcDateTime(object, &here);
}

int Cli_SetSessionPassword(S7Object object, char* password) {
  if (password == nullptr) return errCliInvalidParams;
  return with(object, [&](Client& client) { return enterPassword(client.connection, password); });
}
int Cli_ClearSessionPassword(S7Object object) {
  return with(object, [](Client& client) { return clearPassword(client.connection); });
}
