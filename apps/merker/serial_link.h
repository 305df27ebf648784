// X27 of a station and the outside, between two slices of virtual time: characters go both ways, in
// bounded portions; what came in can be recorded and played again at the same virtual instants.
#pragma once

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "plc/controller.h"
#include "serial/coupling.h"
#include "serial_stream.h"

namespace merker::app {

class SerialLink {
 public:
  // Null without a connection to the outside or a recording of one; `reason` says what is wrong,
  // and is empty if nothing is.
  static std::unique_ptr<SerialLink> open(const serial::Connection& connection,
                                          const std::string& record, controller::Controller& plc,
                                          std::string& reason);

  // At the PLC's present instant.
  void exchange();
  // When a recording has the next characters; never otherwise.
  Instant next() const;
  bool connected() const { return connected_; }
  bool realTime() const { return stream_ != nullptr; }
  std::string name() const { return stream_ ? stream_->name() : "recording"; }

 private:
  explicit SerialLink(controller::Controller& plc) : plc_(plc) {}
  struct Record {
    Instant at;
    enum class Kind : std::uint8_t { In, Faulty, Cut, Connect } kind = Kind::In;
    serial::Bytes bytes;
  };
  bool readRecords(const std::string& file, std::string& reason);
  bool readRecord(std::string_view line);
  serial::Coupling* coupling();
  void take(serial::Coupling& coupling);
  void give(serial::Coupling& coupling);
  void connect(serial::Coupling& coupling, bool connected);
  void play(serial::Coupling& coupling, const Record& record);
  void keep(const char* kind, const serial::Bytes& bytes);

  controller::Controller& plc_;
  std::unique_ptr<SerialStream> stream_;
  serial::Bytes unsent_;
  bool connected_ = true;  // a line is whole at the beginning
  std::ofstream record_;
  std::vector<Record> records_;
  std::size_t played_ = 0;
};

}  // namespace merker::app
