// The bytes of DB 36 that show how far a job is: number 1 = DL 0, 2 = DR 0, …, 65 = DL 32, that
// one for jobs that overtake the others (S5-FM-27).
#pragma once

#include <cstdint>
#include <optional>

#include "softplc/machine.h"

namespace merker::nc {

constexpr unsigned kInterfaceBytes = 65, kAlarmByte = 65;

// Which bit is which signal. Only BELEGT = bit 3 is printed; the others follow the order of the
// signal list (OP-15).
struct HandshakeBits {
  std::uint8_t requested = 0;  // DATENÜBERGABE ANGEFORDERT
  std::uint8_t full = 1;       // FIFO VOLL
  std::uint8_t running = 2;    // DATENÜBERGABE LÄUFT
  std::uint8_t busy = 3;       // DATENÜBERGABE BELEGT
  std::uint8_t done = 4;       // DATENÜBERGABE BEENDET
  std::uint8_t error = 7;      // FEHLER
};

// The number that the code of "L DL 15" or "L DR 15" stands for (S5-FM-30).
std::optional<unsigned> interfaceNumber(std::uint16_t code);

// One byte in the memory of a PLC; nothing happens without DB 36.
class InterfaceByte {
 public:
  InterfaceByte(sinumerik::Machine& machine, unsigned number);
  bool exists() const { return word_ != nullptr; }
  bool bit(unsigned bit) const { return exists() && (*word_ >> (shift_ + bit) & 1) != 0; }
  void set(unsigned bit, bool on);

 private:
  std::uint16_t* word_ = nullptr;
  unsigned shift_ = 0;
};

}  // namespace merker::nc
