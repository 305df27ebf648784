// Boxes on a belt, light barriers across it, sliders beside it (S7-VIS-07). A box is pushed when it
// stands in front of a slider that comes out; a slider that is out stops what runs against it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace merker::plant {

enum class BoxSize : std::uint8_t { None, Small, Middle, Large };

// Lengths in m along the belt, from the light barriers.
struct Box {
  BoxSize size = BoxSize::None;
  double front = 0;
  double pushed = 0;  // 0: on the belt, 1: in the bin
  int slider = -1;    // that pushes it
};

class Belt {
 public:
  static constexpr std::size_t kSliders = 3, kBoxes = 6;
  static constexpr double kLength = 0.08;  // of a box
  static constexpr double kStart = -0.2, kEnd = 1.0;
  // Of a slider from in to out.
  static constexpr double kStrokeTime = 0.2;  // s
  // Middle of the sliders: 3, 5, 7 s behind the barriers at 0.1 m/s (S7-VIS-12 to S7-VIS-14), and
  // what a box goes on while the slider comes out half.
  static constexpr std::array<double, kSliders> kPlaces{0.35, 0.55, 0.75};

  // False: there is no room at the beginning of the belt.
  bool put(BoxSize size);
  void move(double seconds, double metresPerSecond, const std::array<bool, kSliders>& out);
  // So many times; quicker while no box is in the way of another and no slider comes to one.
  void move(double seconds, double metresPerSecond, const std::array<bool, kSliders>& out,
            std::int64_t count);

  // Not before so many seconds does a barrier change, at this speed of the belt.
  double silence(double metresPerSecond) const;
  // Of a box that is put on it.
  static double timeToBarriers(double metresPerSecond);

  bool interrupted(BoxSize from) const;  // the barrier that boxes of this size reach
  const std::array<Box, kBoxes>& boxes() const { return boxes_; }
  double stroke(std::size_t slider) const { return strokes_[slider]; }  // 0: in, 1: out

  struct Counts {
    std::array<int, kSliders> bins{};
    int good = 0, wrong = 0;  // wrong: another bin, fallen off, or past the end
  };
  const Counts& counts() const { return counts_; }

 private:
  std::int64_t freeSteps(double stroke, const std::array<bool, kSliders>& out) const;
  bool freeFor(double way) const;
  bool moveSlider(std::size_t slider, bool out, double seconds);
  void push(std::size_t slider);
  void slide(Box& box, double seconds);
  void carry(Box& box, double way) const;
  void carryFreely(double way, std::int64_t count);
  void moveSliders(double stroke, const std::array<bool, kSliders>& out, std::int64_t count);
  double obstacle(const Box& box) const;
  void deliver(Box& box);
  void lose(Box& box);

  std::array<Box, kBoxes> boxes_{};
  std::array<double, kSliders> strokes_{};
  Counts counts_;
};

}  // namespace merker::plant
