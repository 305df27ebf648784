// Any tree has one form that is stored; it is read again as it is.
#include "graph/canonical.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/read.h"
#include "graph/write.h"
#include "graph5/rules.h"
#include "graph7/rules.h"
#include "random_networks.h"

namespace merker::graph {
namespace {

using test::kFirstWire;

std::string text(const Statements& statements) {
  std::string out;
  for (const Statement& statement : statements) {
    out += name(statement.op);
    if (!statement.operand.text.empty()) out += " " + statement.operand.text;
    out += "; ";
  }
  return out;
}

void comesBack(const Rules& rules, const Network& wild) {
  Network network = canonical(wild, rules, kFirstWire);
  const Statements statements = writeNumbered(network, rules);
  RC_LOG() << text(statements) << "\n";
  const auto again = read(statements, rules, Unfinished::Allowed);
  if (!again) {
    const Reason reason = again.error().reason;
    RC_LOG() << again.error().statement << " " << graph::text(reason) << "\n";
    RC_PRE(reason != Reason::Brackets && reason != Reason::OneBox);
  }
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == network);
}

RC_GTEST_PROP(Canonical, ComesBackInStep7, ()) {
  comesBack(graph7::rules(), *test::networks(graph7::rules()));
}
RC_GTEST_PROP(Canonical, ComesBackInStep5, ()) {
  comesBack(graph5::rules(), *test::networks(graph5::rules()));
}
RC_GTEST_PROP(Canonical, IsCanonicalAlready, ()) {
  const Network once = canonical(*test::networks(graph7::rules()), graph7::rules(), kFirstWire);
  RC_ASSERT(canonical(once, graph7::rules(), kFirstWire) == once);
}

}  // namespace
}  // namespace merker::graph
