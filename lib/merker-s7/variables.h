// Reading and writing of variables over a connection, in as many PDUs as they need.
#pragma once

#include <span>

#include "connection.h"
#include "merker_s7.h"

namespace merker::s7client {

// A row of elements of one area.
struct Elements {
  int area = 0, db = 0, start = 0, amount = 0, wordLen = 0;
};

// Bytes of an element; 0: there is no such element.
std::size_t elementBytes(int wordLen);

// 0, or an error of merker_s7.h. `data` has all bytes of the elements.
int read(Connection& connection, const Elements& elements, std::uint8_t* data);
int write(Connection& connection, const Elements& elements, const std::uint8_t* data);
// In one PDU; the error of each item is in its Result.
int readMany(Connection& connection, std::span<TS7DataItem> items);
int writeMany(Connection& connection, std::span<TS7DataItem> items);

}  // namespace merker::s7client
