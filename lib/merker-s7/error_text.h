// The errors of merker_s7.h as sentences.
#pragma once

#include <string_view>

namespace merker::s7client {

std::string_view errorText(int error);

}  // namespace merker::s7client
