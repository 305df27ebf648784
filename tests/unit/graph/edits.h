// Edits and networks as texts: "U E 0.0; = A 0.0".
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "graph/edit.h"
#include "graph/read.h"
#include "graph7/rules.h"
#include "random_networks.h"
#include "statement_text.h"

namespace merker::graph::edits {

using test::kFirstWire;
using test::operand;
using test::statements;

inline Network networkOf(const std::string& text, const Rules& rules = graph7::rules(),
                         Unfinished unfinished = Unfinished::Allowed) {
  const auto network = read(statements(text), rules, unfinished);
  EXPECT_TRUE(network) << text;
  return network ? *network : Network{};
}

inline std::string edited(const std::string& before, const Edit& edit,
                          const Rules& rules = graph7::rules()) {
  const auto after = apply(networkOf(before, rules), edit, rules, kFirstWire);
  if (!after) return "refused: " + std::string(text(after.error(), Language::English));
  return fmt::format("{} [{}:{}]", test::text(after->statements), after->select.node,
                     after->select.pin);
}

// `at`: "3", "3:1" with a pin, "0-3" a gate from its first statement to its last.
inline Selection selection(const std::string& text) {
  Selection out;
  if (text.empty()) return out;
  out.node = std::stoi(text);
  if (const auto mark = text.find(':'); mark != std::string::npos)
    out.pin = std::stoi(text.substr(mark + 1));
  else if (const auto dash = text.find('-'); dash != std::string::npos) {
    out.first = out.node;
    out.node = std::stoi(text.substr(dash + 1));
  }
  return out;
}

inline Edit insert(const std::string& at, Place place, const std::string& element,
                   std::vector<std::string> operands = {}) {
  Edit edit;
  edit.at = selection(at);
  edit.place = place;
  edit.element = element;
  for (const std::string& text : operands)
    edit.operands.push_back(text.empty() ? Operand{} : operand(text));
  return edit;
}
inline Edit act(Action action, const std::string& at, const std::string& field = "") {
  Edit edit;
  edit.action = action;
  edit.at = selection(at);
  if (!field.empty()) edit.operands.push_back(operand(field));
  return edit;
}

struct Row {
  std::string before;
  Edit edit;
  std::string after;
};
inline void expectAll(const std::vector<Row>& rows, const Rules& rules = graph7::rules()) {
  for (const Row& row : rows)
    EXPECT_EQ(edited(row.before, row.edit, rules), row.after) << row.before;
}

constexpr auto kBehind = Place::Behind, kBefore = Place::Before, kParallel = Place::Parallel,
               kBranch = Place::Branch, kAtPin = Place::AtPin;

}  // namespace merker::graph::edits
