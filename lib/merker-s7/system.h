// The system status of a CPU (SZL), its clock, its password.
#pragma once

#include <ctime>
#include <string_view>

#include "connection.h"
#include "merker_s7.h"

namespace merker::s7client {

// Length of a record, how many, the records; big-endian as the CPU has them.
struct SystemList {
  std::uint16_t recordLength = 0, records = 0;
  s7comm::Bytes data{};
};
int readList(Connection& connection, int number, int index, SystemList& list);

int orderCode(Connection& connection, TS7OrderCode& code);
int cpuInfo(Connection& connection, TS7CpuInfo& info);
int cpInfo(Connection& connection, TS7CpInfo& info);
int protection(Connection& connection, TS7Protection& levels);
int plcStatus(Connection& connection, int& status);

int readClock(Connection& connection, std::tm& time);
int setClock(Connection& connection, const std::tm& time);
int enterPassword(Connection& connection, std::string_view password);
int clearPassword(Connection& connection);

}  // namespace merker::s7client
