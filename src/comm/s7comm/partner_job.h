// What a program and the partner of a configured connection have for each other: jobs of the
// program and their results, and telegrams that came (S7-SFB-10).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "s7comm/error.h"
#include "s7comm/item.h"

namespace merker::s7comm {

constexpr std::size_t kLongestTelegram = 65'534;  // octets (BSEND of an S7-400)

// STATUS of the blocks of S7 communication, with ERROR = 1 (System and Standard Functions, volume
// 2/2, chapter 21).
enum class PartnerStatus : std::uint8_t {
  Done = 0,
  NoConnection = 1,     // not configured, not there yet, or lost
  Refused = 2,          // by the partner, or it breaks the protocol
  UnknownReceiver = 3,  // R_ID
  WrongLength = 4,      // of SD_i, RD_i, ADDR_i or LEN, or their types
  Reset = 5,            // by R
  Disabled = 6,         // EN_R of the partner is 0
  NotReady = 7,         // it has not taken what came before
  NoAccess = 8,         // to what the partner has
  NoMemory = 10,        // of this CPU: the data block is missing, or write-protected
  Occupied = 18,        // another block has this R_ID
  TooManyJobs = 20
};

// An area of USEND.
struct SentArea {
  DataUnit unit = DataUnit::Byte;
  Bytes octets{};
};

struct PartnerJob {
  enum class Kind : std::uint8_t { BlockSend, Get, Put, Send } kind = Kind::BlockSend;
  std::uint32_t number = 0;  // of the program's own
  std::uint32_t rid = 0;     // BlockSend, Send
  std::vector<AnyItem> items{};
  std::vector<Bytes> values{};    // of each item; BlockSend has one
  std::vector<SentArea> areas{};  // Send
};

struct PartnerResult {
  std::uint32_t number = 0;  // of the job
  PartnerStatus status = PartnerStatus::Done;
  std::vector<Bytes> values{};  // GET
};

// A receiving block, as it stands after its last call.
struct Receiver {
  std::uint32_t rid = 0;
  bool enabled = false;
  bool removed = false;                   // it is there no more
  std::size_t octets = kLongestTelegram;  // that have room
  bool blocks = true;                     // BRCV; else URCV
};

struct Telegram {
  std::uint32_t rid = 0;
  Bytes octets{};
  bool tooLong = false;  // for its receiver: it was refused, and there are no octets
};

// What a USEND of the partner has sent.
struct Notice {
  std::uint32_t rid = 0;
  std::vector<SentArea> areas{};
  bool overwrote = false;  // one before it that the program has not taken
};

// What a program wants between two ends of a cycle, in this order.
struct ToPartner {
  bool restart = false;  // whatever ran for it is over
  std::vector<Receiver> receivers{};
  std::vector<PartnerJob> jobs{};
  std::vector<std::uint32_t> aborted{};  // jobs that R ends
  bool empty() const { return !restart && receivers.empty() && jobs.empty() && aborted.empty(); }
};

struct FromPartner {
  std::optional<bool> connected{};  // if that has changed
  std::vector<PartnerResult> results{};
  std::vector<Telegram> telegrams{};
  std::map<std::uint32_t, std::size_t> begun{};  // octets of telegrams that are not whole, by R_ID
  std::map<std::uint32_t, Notice> notices{};     // by R_ID; of each the newest one
  void note(Notice notice) {
    const std::uint32_t rid = notice.rid;
    notice.overwrote = notices.contains(rid);
    notices.insert_or_assign(rid, std::move(notice));
  }
};

}  // namespace merker::s7comm
