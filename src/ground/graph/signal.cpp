#include "graph/signal.h"

namespace merker::graph {
namespace {

bool isOpenSeries(const Node& node) { return node.kind == NodeKind::Series && !node.bracketed; }

Node inSeries(std::optional<Node> before, Node node) {
  if (!before) return node;
  Node series;
  if (isOpenSeries(*before)) {
    series = std::move(*before);
  } else {
    series.first = before->first;
    series.children.push_back(std::move(*before));
  }
  series.last = node.last;
  series.children.push_back(std::move(node));
  return series;
}

}  // namespace

bool Signal::join(Node node) {
  if (node.join == Join::And) {
    if (notBehindTerm_) return false;
    if (termOpen_) {
      current_ = inSeries(std::move(current_), std::move(node));
    } else {
      closeTerms();
      whole_ = inSeries(std::move(whole_), std::move(node));
    }
    return true;
  }
  const NodeKind kind = node.join == Join::Or ? NodeKind::Parallel : NodeKind::Xor;
  if (collecting_ && terms_.kind != kind) closeTerms();
  if (termOpen_ && !current_) return false;
  notBehindTerm_ = false;
  if (!collecting_ && !whole_) {  // the first one of an expression
    whole_ = std::move(node);
    return true;
  }
  beginCollecting(kind);
  closeTerm();
  add(std::move(node));
  return true;
}

void Signal::beginCollecting(NodeKind kind) {
  if (collecting_) return;
  terms_ = {};
  terms_.kind = kind;
  terms_.first = whole_->first;
  collecting_ = true;
  add(std::move(*whole_));
  whole_.reset();
}

void Signal::add(Node node) {
  terms_.last = node.last;
  terms_.children.push_back(std::move(node));
}

void Signal::closeTerm() {
  if (current_) add(std::move(*current_));
  current_.reset();
  termOpen_ = false;
}

bool Signal::beginTerm() {
  if (empty() || (termOpen_ && !current_)) return false;
  notBehindTerm_ = false;
  if (collecting_ && terms_.kind != NodeKind::Parallel) closeTerms();
  beginCollecting(NodeKind::Parallel);
  closeTerm();
  termOpen_ = true;
  return true;
}

void Signal::closeTerms() {
  if (!collecting_) return;
  closeTerm();
  ++nesting_;
  whole_ = std::move(terms_);
  terms_ = {};
  collecting_ = false;
}

bool Signal::append(Node node) {
  if (empty() || (termOpen_ && !current_)) return false;
  notBehindTerm_ = termOpen_ && node.kind == NodeKind::Not;
  closeTerms();
  whole_ = inSeries(std::move(whole_), std::move(node));
  return true;
}

std::optional<Node> Signal::take() {
  if (termOpen_ && !current_) return std::nullopt;
  closeTerms();
  std::optional<Node> node = std::move(whole_);
  whole_.reset();
  return node;
}

}  // namespace merker::graph
