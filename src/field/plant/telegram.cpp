#include "plant/telegram.h"

#include <array>

namespace merker::plant {
namespace {

constexpr TelegramWord kWords1[] = {
    {"STW1", true, 0}, {"NSOLL_A", true, 1}, {"ZSW1", false, 0}, {"NIST_A", false, 1}};

// STW2 (word 2) and ZSW2 (word 2) carry the sign of life of isochronous drives only: unused.
constexpr TelegramWord kWords9[] = {{"STW1", true, 0},          {"SATZANW", true, 1},
                                    {"MDI_TARPOS", true, 3, 2}, {"MDI_VELOCITY", true, 5, 2},
                                    {"MDI_ACC", true, 7},       {"MDI_DEC", true, 8},
                                    {"MDI_MOD", true, 9},       {"ZSW1", false, 0},
                                    {"AKTSATZ", false, 1},      {"XIST_A", false, 3, 2}};

constexpr std::array kTelegrams{&kTelegram1, &kTelegram9};

}  // namespace

constexpr Telegram kTelegram1{"Standard telegram 1", 2, 2, kWords1};
constexpr Telegram kTelegram9{"Standard telegram 9", 10, 5, kWords9};

std::span<const Telegram* const> telegrams() { return kTelegrams; }

}  // namespace merker::plant
