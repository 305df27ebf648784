// All configured connections of a CPU to other stations of the project: their telegrams, whichever
// subnet brings them.
#pragma once

#include <memory>
#include <vector>

#include "system/basic_communication.h"
#include "system/send_receive_link.h"
#include "system/subnet_link.h"
#include "system/variable_server.h"

namespace merker::system {

class SubnetLinks {
 public:
  // `cpu` outlives it.
  explicit SubnetLinks(cpu::Cpu& cpu) : server_(cpu) {}
  bool empty() const { return links_.empty() && cpLinks_.empty(); }

  // `mpi` reads the node of an MPI interface, so telegrams of connections come from it.
  void add(const network::ConnectionEnd& end, std::uint16_t pdu, Connections& program,
           const BasicCommunication& mpi);
  // Of a CP; it has an Ethernet of its own.
  void add(const network::ConnectionEnd& end, SendReceive& cp);
  // At the end of a cycle.
  void serve(BasicCommunication& mpi, Connections& program, SendReceive& cp, Instant now);
  // The CPU is in STOP: it serves its partners; without power nobody hears.
  void rest(BasicCommunication& mpi, SendReceive& cp, Instant now, bool powered);
  // When rest() is to be called again.
  Instant next() const;

 private:
  void read(network::Node& node);
  void receive(BasicCommunication& mpi, SendReceive& cp, Instant now);
  void hear(const network::Node& node, const network::Telegram& telegram, Instant now);
  void hearCp(const network::Node& node, const network::Telegram& telegram, SendReceive& cp,
              Instant now);
  void wake(Instant now);
  void sleep(SendReceive& cp);

  VariableServer server_;
  std::vector<std::unique_ptr<SubnetLink>> links_;
  std::vector<std::unique_ptr<SendReceiveLink>> cpLinks_;
  std::vector<network::Node*> nodes_;  // that nobody else reads
  bool asleep_ = false;
};

}  // namespace merker::system
