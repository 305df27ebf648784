// How an element of a network is named from outside: by its statements.
#pragma once

namespace merker::graph {

// Fields of an element; the pins follow.
constexpr int kNoPin = -1, kEnable = -2;
constexpr int kOwn = 0;  // above it: of a contact or coil, the timer of a box, the block of a CALL
constexpr int kFirstPin = 1;  // pin n of a box, argument n of a CALL, value n of a coil: kFirstPin
                              // + n; of an edge its memory

// A contact, box, coil, connector.. is named by its last statement, whose status it shows, and so
// is a group in brackets. A group without brackets, the gate of FUP, has the last statement of its
// last element and is told apart by its first one.
struct Selection {
  int node = -1;  // number of the last statement; -1: the network
  int pin = kNoPin;
  int first = -1;  // of a group without brackets: number of its first statement
  bool operator==(const Selection&) const = default;
};

}  // namespace merker::graph
