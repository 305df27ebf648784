// An S7 connection of the side that is asked: PDUs in, answers out. A job that the PLC carries out
// later is answered then; reads behind a write of the same connection see what it wrote, and
// answers come in the order of their jobs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "s7comm/outlet.h"
#include "s7comm/plc.h"
#include "s7comm/rest.h"

namespace merker::s7comm {

struct Job;

// What a CPU of the S7-300 offers.
struct Offer {
  std::uint16_t pdu = 240;  // octets
  std::uint16_t jobs = 8;   // at the same time
};

class Session : public std::enable_shared_from_this<Session> {
 public:
  using Send = std::function<void(Bytes pdu)>;

  // A block that the client fetches, piece by piece.
  struct Upload {
    std::uint32_t number = 0;
    Bytes octets{};
    std::size_t sent = 0;
  };

  // A block that the client hands over, piece by piece: this side asks for each.
  struct Download {
    std::optional<BlockName> name{};  // nothing: none comes
    std::size_t announced = 0;        // octets
    Bytes octets{};
  };

  // Hears the answer to a job of this side.
  using Heard = void (*)(const Job& job, const Pdu& answer);

  // Watches over the connection; what is called outlives it.
  struct Guard {
    // Hears each error that is answered.
    std::function<void(Error)> refused = [](Error) {};
    // Has a password looked at when it is its turn, now or later; false: it counts as wrong.
    std::function<void(std::function<void(bool mayLook)> look)> turn =
        [](const std::function<void(bool)>& look) { look(true); };
    // Hears of each wrong password.
    std::function<void()> wrong = [] {};
  };

  // `plc` outlives it.
  Session(Plc& plc, Send send, Offer offer = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // False: this is no S7 communication, the connection is to be closed. Not while busy().
  bool receive(View bytes);
  // As many jobs wait as were agreed on, or one that has to wait for them.
  bool busy() const { return !held_.empty() || waiting_ >= jobs_; }
  // The client has not answered what this side asked.
  bool asks() const { return heard_ != nullptr; }
  // It will not any more: a block that was on its way is given up.
  void giveUp();
  // Hears that it is not busy any more.
  void whenReady(std::function<void()> ready) { ready_ = std::move(ready); }

  void guardBy(Guard guard) { guard_ = std::move(guard); }

  // Whether the line takes what the PLC says unasked; deliver() when it does again.
  void roomBy(std::function<bool()> room) { room_ = std::move(room); }
  void deliver();
  // Where the PLC sends what it says later, unasked; it outlives the connection.
  const std::shared_ptr<Outlet>& outlet() const { return outlet_; }
  // The connection has gone; whatever waits for the PLC still keeps the session.
  void end() { outlet_->close(); }

  std::uint16_t pdu() const { return pdu_; }
  bool isSetUp() const { return setUp_; }
  // The other side has agreed to what this one asked.
  void agreed(std::uint16_t pdu) { agree(pdu, offer_.jobs); }

 private:
  friend struct Job;
  void agree(std::uint16_t pdu, std::uint16_t jobs);
  bool take(View bytes);
  bool isAnswer(const Pdu& pdu) const;
  void hear(const Pdu& answer);
  void ask(View parameters, Heard heard);
  void answered();

  Plc& plc_;
  Send send_;
  Offer offer_;
  Guard guard_;
  std::function<void()> ready_;
  std::function<bool()> room_;
  std::shared_ptr<Outlet> outlet_ = std::make_shared<Outlet>();
  std::uint16_t pdu_, jobs_ = 1;
  bool setUp_ = false, inside_ = false;  // inside_: receive() is running
  std::size_t waiting_ = 0;              // jobs that the PLC has and has not answered
  Bytes held_;                           // a PDU that waits for these
  Rests rests_;
  Upload upload_;
  Download download_;
  Heard heard_ = nullptr;
  std::uint16_t asked_ = 0;  // reference of the last job of this side
  std::uint8_t askedFunction_ = 0;
  std::string password_;  // that was entered and was right
};

}  // namespace merker::s7comm
