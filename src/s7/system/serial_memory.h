// The memory of a program as the sub-module PtP sees it: data blocks for SD_1 and RD_1, areas for
// the jobs of a partner (RK 512).
#pragma once

#include "cpu/cpu.h"
#include "cpu/memory_access.h"
#include "serial/link_blocks.h"

namespace merker::system {

class ProgramBlocks : public serial::DataBlocks {
 public:
  // `access`: what the blocks are for. Nothing can be written to a write-protected one.
  ProgramBlocks(cpu::Machine& machine, cpu::Access access) : m_(machine), access_(access) {}
  std::optional<std::size_t> size(std::uint32_t block) const override;
  serial::Bytes read(const serial::Place& from, std::size_t count) const override;
  void write(const serial::Place& to, std::span<const std::uint8_t> data) override;

 private:
  cpu::Machine& m_;
  cpu::Access access_;
};

class ProgramMemory : public serial::LinkMemory {
 public:
  explicit ProgramMemory(cpu::Machine& machine) : m_(machine) {}
  std::optional<std::size_t> size(char type, std::uint8_t block) const override;
  bool writable(std::uint8_t block) const override;
  serial::Bytes read(char type, std::uint8_t block, std::size_t offset,
                     std::size_t count) const override;
  void write(std::uint8_t block, std::size_t offset, std::span<const std::uint8_t> data) override;
  bool flag(const serial::Flag& flag) const override;
  void setFlag(const serial::Flag& flag) override;

 private:
  cpu::Machine& m_;
};

}  // namespace merker::system
