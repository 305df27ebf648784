// How the pictures of traces and of campaigns look.
#pragma once

#include <array>
#include <string_view>

namespace merker::simulator {

inline constexpr std::array<std::string_view, 5> kPlotColours = {"#1f6fb4", "#d2691e", "#2e8b57",
                                                                 "#8b3a8b", "#808000"};
inline constexpr std::string_view kPlotStyle =
    "<style>text{font:12px sans-serif;fill:#333}"
    ".title{font-size:15px;font-weight:bold}.grid{stroke:#ddd;fill:none}"
    ".axis{stroke:#333;fill:none}.curve{fill:none;stroke-width:1.5}</style>\n";

}  // namespace merker::simulator
