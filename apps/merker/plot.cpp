// merker plot TRACE.csv|RESULTS.sqlite -o FILE.svg
#include "scenario/plot.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/text.h"
#include "campaign/picture.h"
#include "command.h"
#include "output.h"
#include "scenario/duration.h"
#include "scenario/line.h"

namespace merker::app {
namespace {

using simulator::Curve;

struct PlotOptions {
  std::string trace, output, title, from, to;
  std::vector<std::string> rows;
  campaign::PictureWish results;  // without the title
};

std::string listOf(const std::vector<Curve>& curves) {
  std::string list;
  for (const Curve& curve : curves) list += (list.empty() ? "" : ", ") + curve.operand;
  return list;
}

// "DB41.PV = temperature, DB41.SP_INT"
std::vector<simulator::PlotRow> chosenRows(const PlotOptions& options,
                                           const std::vector<Curve>& curves, Problems& problems) {
  std::vector<simulator::PlotRow> rows;
  for (const std::string& text : options.rows) {
    simulator::PlotRow& row = rows.emplace_back();
    for (const std::string_view part : simulator::splitList(text)) {
      const auto sign = part.find('=');
      const std::string_view operand = trim(part.substr(0, sign));
      const auto found = std::find_if(curves.begin(), curves.end(), [&](const Curve& curve) {
        return equalsIgnoreCase(curve.operand, operand);
      });
      if (found == curves.end())
        problems.add(ProblemCode::P0991, Position{options.trace}, operand, listOf(curves));
      else
        row.push_back({*found, sign == std::string_view::npos
                                   ? found->operand
                                   : std::string(trim(part.substr(sign + 1)))});
    }
  }
  return rows;
}

// Seconds; `standard` if the option is not there. False if it is no length of time.
bool readTime(const std::string& option, const std::string& text, double standard,
              double& seconds) {
  seconds = standard;
  if (text.empty()) return true;
  const auto duration = simulator::parseDuration(text);
  if (duration) seconds = static_cast<double>(duration->ns) / 1e9;
  if (!duration)
    std::cerr << "merker plot: " << option << ": '" << text
              << "' is not a valid duration; write 5s, 2m\n";
  return duration.has_value();
}

int write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return kGood;
  std::cerr << "merker plot: cannot write " << path << ": " << std::strerror(errno) << '\n';
  return kUnreadable;
}

// The picture is SVG, and never takes the place of the trace.
bool isPicture(const PlotOptions& options) {
  std::error_code unknown;
  const std::filesystem::path output = options.output;
  const bool same = std::filesystem::equivalent(output, options.trace, unknown);
  if (!same && equalsIgnoreCase(output.extension().string(), ".svg")) return true;
  std::cerr << "merker plot: " << options.output
            << (same ? " is the trace itself" : " is not a valid name of an SVG picture")
            << "; write -o FILE.svg\n";
  return false;
}

int tell(const Problem& problem) {
  Problems problems;
  problems.add(problem);
  printProblems(problems, [](const std::string&) { return nullptr; });
  const bool wish = problem.code == ProblemCode::P0787 || problem.code == ProblemCode::P0789;
  return wish ? kUsage : kUnreadable;
}

int plotResults(const PlotOptions& options) {
  const auto table = campaign::readTable(options.trace);
  if (!table) return tell(table.error());
  campaign::PictureWish wish = options.results;
  wish.title = options.title;
  const auto picture = campaign::draw(table.value(), wish, options.trace);
  return picture ? write(options.output, picture.value()) : tell(picture.error());
}

int plotTrace(const PlotOptions& options) {
  Problems problems;
  const auto file = source::readSource(options.trace, source::kLargestTrace);
  if (!file) {
    problems.add(file.error());
    printProblems(problems, [](const std::string&) { return nullptr; });
    return kUnreadable;
  }
  const auto curves = simulator::readCurves(file.value(), problems);
  simulator::Plot plot{options.title, chosenRows(options, curves, problems), 0, 0};
  if (plot.rows.empty()) plot.rows = simulator::rowsOf(curves);
  printProblems(problems, [&](const std::string&) { return &file.value(); });
  if (problems.hasErrors()) return kProblems;
  if (!readTime("--from", options.from, 0, plot.from) ||
      !readTime("--to", options.to, simulator::endOf(curves), plot.to))
    return kUsage;
  if (plot.from < plot.to) return write(options.output, drawSvg(plot));
  std::cerr << "merker plot: --from must be before --to and before the end of the trace\n";
  return kUsage;
}

// Options of the other kind of file would be without effect.
bool fits(const PlotOptions& options, bool results) {
  const campaign::PictureWish& wish = options.results;
  const bool ofResults = !(wish.x + wish.y + wish.by + wish.heat).empty();
  const bool ofTrace = !options.rows.empty() || !(options.from + options.to).empty();
  if (results ? !ofTrace : !ofResults) return true;
  std::cerr << "merker plot: " << options.trace
            << (results ? " has results of a campaign; --row, --from and --to are for a trace\n"
                        : " is no file of results; --x, --y, --by and --heat are for a campaign\n");
  return false;
}

int plot(const PlotOptions& options) {
  if (!isPicture(options)) return kUsage;
  const bool results = campaign::isDatabase(options.trace);
  if (!fits(options, results)) return kUsage;
  return results ? plotResults(options) : plotTrace(options);
}

}  // namespace

void addPlot(CLI::App& program, int& result) {
  auto* command =
      program.add_subcommand("plot", "a trace or the results of a campaign as a picture, in SVG");
  auto options = std::make_shared<PlotOptions>();
  command
      ->add_option("TRACE", options->trace, "what `merker run --trace` or `merker campaign` wrote")
      ->required();
  command->add_option("-o,--output", options->output, "the picture: FILE.svg")->required();
  command
      ->add_option("--row", options->rows,
                   "curves over one axis, each with a name if you like: \"DB41.PV = temperature\"; "
                   "once for each row")
      ->allow_extra_args(false);
  command->add_option("--title", options->title, "title above the picture");
  command->add_option("--from", options->from, "only from this instant on: 5s");
  command->add_option("--to", options->to, "only up to this instant: 2m");
  command->add_option("--x", options->results.x,
                      "results: the parameter along the picture; otherwise the first one");
  command->add_option("--y", options->results.y,
                      "results: the measure that is drawn; with --heat the parameter upwards");
  command->add_option("--by", options->results.by,
                      "results: a curve for each value of this parameter");
  command->add_option("--heat", options->results.heat,
                      "results: this measure as colours over two parameters");
  command->footer(
      "Without --row each operand has a row. Results are drawn with quantiles of all runs.\n"
      "Examples:\n"
      "  merker plot plant.csv -o plant.svg\n"
      "  merker plot oven.csv -o oven.svg --row \"DB41.SP_INT = setpoint, DB41.PV = temperature\" "
      "--row \"A 124.0 = heating\"\n"
      "  merker plot sweep.sqlite -o sweep.svg --x plant.Vessel.stroke --y emptied\n"
      "  merker plot sweep.sqlite -o map.svg --x plant.Vessel.stroke --y plant.Vessel.minimum "
      "--heat emptied");
  command->callback([options, &result] { result = plot(*options); });
}

}  // namespace merker::app
