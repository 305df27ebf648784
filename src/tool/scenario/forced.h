// What is forced, and what may be forced beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "address/reference.h"
#include "base/problem.h"

namespace merker::simulator {

struct Forced {
  address::Reference operand;
  std::uint32_t value = 0;
};

bool samePlace(const address::Reference& a, const address::Reference& b);
bool overlap(const address::Reference& a, const address::Reference& b);

// P1219: an operand that shares bits with a forced one; the same operand again takes its new value.
std::optional<Problem> checkForce(const std::vector<Forced>& list,
                                  const address::Reference& operand);

// Within one list the same operand again is refused, too: P0988.
std::optional<Problem> checkOnce(const std::vector<Forced>& list,
                                 const address::Reference& operand);

// What a scenario has forced so far. The texts say why an operand cannot be forced or set beside
// it; empty: it can.
class ForceList {
 public:
  std::string whyNotForced(const address::Reference& operand) const;
  // The same where a list names operands: the same one again is refused, too.
  std::string whyNotTwice(const address::Reference& operand) const;
  // A forced input can be set at its terminal, where it waits.
  std::string whyNotSet(const address::Reference& operand) const;
  void add(const address::Reference& operand);
  void clear(std::size_t station);  // of this one, the first is 0
  // A memory reset of the coupled control alone.
  void clearPartner();

 private:
  std::vector<Forced> list_;
};

}  // namespace merker::simulator
