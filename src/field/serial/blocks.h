// The communication blocks SFB 60 SEND_PTP, SFB 61 RCV_PTP and SFB 62 RES_RCVB, call by call,
// without an instance data block (technology manual 6.5.1; PTP-SFB60 to -SFB62).
#pragma once

#include "serial/call_state.h"
#include "serial/interface.h"

namespace merker::serial {

constexpr std::size_t kPortion = 206;  // bytes that a call copies (PTP-OPEN-12)

// SD_1 or RD_1: from a byte of a data block on.
struct Place {
  std::uint32_t block = 0, offset = 0;
};

// The data blocks of a program.
class DataBlocks {
 public:
  virtual ~DataBlocks() = default;
  virtual std::optional<std::size_t> size(std::uint32_t block) const = 0;  // bytes, if it exists
  virtual Bytes read(const Place& from, std::size_t count) const = 0;
  virtual void write(const Place& to, std::span<const std::uint8_t> data) = 0;
};
// None: the area can be used (PTP-SFBG-22, PTP-ERR-01, -02).
Event checkPlace(const DataBlocks& blocks, const Place& place, std::size_t count);

struct Control {
  std::uint32_t instance = 0;
  bool request = false;  // REQ; EN_R of RCV_PTP
  bool reset = false;
  bool permitted = true;  // LADDR is the address of the sub-module, its protocol the right one
};

class SendBlock {
 public:
  explicit SendBlock(Interface& interface) : interface_(interface) {}
  void start();
  Answer call(const Control& control, const Place& source, std::int32_t length,
              const DataBlocks& blocks, Instant now);

 private:
  void accept(const Control& control, const Place& source, std::int32_t length,
              const DataBlocks& blocks);
  void finish();
  void reset();
  void copy(const DataBlocks& blocks, Instant now);

  Interface& interface_;
  CallState state_;
  bool running_ = false, handed_ = false;  // handed: to the driver
  Place source_;
  std::size_t length_ = 0;
  Bytes copied_;
};

class ReceiveBlock {
 public:
  explicit ReceiveBlock(Interface& interface) : interface_(interface) {}
  void start();
  struct Received {
    Answer answer;
    std::int32_t length = 0;  // LEN behind the call
  };
  Received call(const Control& control, const Place& target, DataBlocks& blocks);

 private:
  void fetch(const Place& target, DataBlocks& blocks);
  void copy(DataBlocks& blocks);
  void stop(unsigned calls);

  Interface& interface_;
  CallState state_;
  std::optional<Bytes> telegram_;
  Place target_;
  std::size_t copied_ = 0;
  std::int32_t done_ = 0, length_ = 0;  // bytes of the telegram to be reported; LEN
};

class ClearBlock {
 public:
  explicit ClearBlock(Interface& interface) : interface_(interface) {}
  void start() { state_.start(); }
  Answer call(const Control& control);

 private:
  Interface& interface_;
  CallState state_;
};

}  // namespace merker::serial
