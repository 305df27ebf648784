#include "softplc/interrupt_stack.h"

#include <fmt/format.h>

namespace merker::sinumerik {
namespace {

std::uint32_t relative(const Frame& frame, std::uint32_t word) { return word - frame.start; }

std::optional<std::uint16_t> openBlock(const Frame& frame) {
  return frame.data.open ? std::optional(frame.data.number) : std::nullopt;
}

BlockStackEntry entryOf(const Frame& frame) {
  return {frame.block, frame.next * 2, relative(frame, frame.next), openBlock(frame)};
}

std::optional<mc5::BlockId> callerOf(const Machine& m) {
  const auto& frames = m.levels.back().frames;
  if (frames.size() > 1) return frames[frames.size() - 2].block;
  return std::nullopt;
}

void addFrame(InterruptStack& stack, const Machine& m) {
  const Frame& frame = m.levels.back().frames.back();
  const auto& memory = m.blocks.program();
  stack.stepAddress = frame.next * 2;
  if (frame.next > 0 && frame.next <= memory.size()) stack.instruction = memory[frame.next - 1];
  stack.blockAddress = frame.start * 2;
  stack.relativeStep = relative(frame, frame.next);
  stack.block = frame.block;
  stack.caller = callerOf(m);
  stack.dataBlock = openBlock(frame);
  if (!frame.data.open) return;
  stack.dataAddress = frame.data.start * 2;
  stack.dataLength = frame.data.length;
}

}  // namespace

StopPicture takePicture(const Machine& m, std::uint16_t controlRegister) {
  StopPicture picture;
  picture.interrupt.controlRegister = controlRegister;
  if (m.levels.empty()) return picture;
  const Registers& registers = m.levels.back().registers;
  picture.interrupt.akku1 = registers.akku1;
  picture.interrupt.akku2 = registers.akku2;
  picture.interrupt.displays = registers.displays.byte();
  if (!m.levels.back().frames.empty()) addFrame(picture.interrupt, m);
  for (std::size_t level = m.levels.size(); level-- > 0;) {
    const auto& frames = m.levels[level].frames;
    const bool running = level + 1 == m.levels.size();
    for (std::size_t i = frames.size() - (running && !frames.empty() ? 1 : 0); i-- > 0;)
      picture.blocks.push_back(entryOf(frames[i]));
  }
  picture.interrupt.blockStackPointer = static_cast<unsigned>(picture.blocks.size());
  return picture;
}

void addCause(StopPicture& picture, const Machine& m, Alarm alarm) {
  picture.interrupt.causes.set(row(alarm).cause);
  if (alarm != Alarm::BlockStack || m.levels.empty() || m.levels.back().frames.empty()) return;
  picture.blocks.insert(picture.blocks.begin(), entryOf(m.levels.back().frames.back()));
  picture.interrupt.blockStackPointer = static_cast<unsigned>(picture.blocks.size());
}

std::uint16_t controlRegister(bool batteryGood) { return batteryGood ? 0x0004 : 0x0000; }

}  // namespace merker::sinumerik
