// Recognises the statements of an element by its pattern.
#pragma once

#include "graph/cursor.h"
#include "graph/network.h"
#include "graph/rules.h"

namespace merker::graph {

class ExpressionReader;

class BoxReader {
 public:
  BoxReader(Cursor& cursor, ExpressionReader& expressions, const Rules& rules)
      : cursor_(cursor), expressions_(expressions), rules_(rules) {}

  // Whether the next statements could be the first ones of the element behind its first logic: a
  // quick look, so that only few elements are tried.
  static bool couldBegin(const Element& element, const Cursor& cursor);

  // `before`: the signal read so far, which is the logic of the first pin that has some. False: the
  // cursor is where it was. On success the signal is in the box.
  bool read(const Element& element, std::optional<Node>& before, std::vector<Pin>& parameters,
            Node& box);

 private:
  bool items(std::size_t from, std::size_t to);
  bool item(const Item& item);
  bool logic(std::size_t pin);
  bool own(Op op);
  bool value(const Item& item);
  bool group(std::size_t begin);
  bool output(const Item& item);
  bool working(std::vector<Pin>& parameters);
  bool call(std::vector<Pin>& parameters);
  bool end(std::int32_t target);

  bool eno(Eno how);

  Cursor& cursor_;
  ExpressionReader& expressions_;
  const Rules& rules_;
  const Element* element_ = nullptr;
  Node box_;
  const std::optional<Node>* before_ = nullptr;
  bool beforeUsed_ = false;
};

}  // namespace merker::graph
