// The commands of `merker`. Each adds itself to the program's options; when it was chosen it runs
// while the options are read and leaves its exit code in `result`.
#pragma once

namespace CLI {
class App;
}

namespace merker::app {

enum ExitCode : int { kGood = 0, kProblems = 1, kUsage = 2, kFault = 3, kUnreadable = 4 };

void addCheck(CLI::App& program, int& result);
void addRun(CLI::App& program, int& result);
void addTest(CLI::App& program, int& result);
void addList(CLI::App& program, int& result);
void addHw(CLI::App& program, int& result);
void addNetwork(CLI::App& program, int& result);
void addDisassemble(CLI::App& program, int& result);
void addAssemble(CLI::App& program, int& result);
void addDebug(CLI::App& program, int& result);
void addDiag(CLI::App& program, int& result);
void addMonitor(CLI::App& program, int& result);
void addXref(CLI::App& program, int& result);
void addExport(CLI::App& program, int& result);
void addGsd(CLI::App& program, int& result);
void addTags(CLI::App& program, int& result);
void addPlot(CLI::App& program, int& result);
void addCampaign(CLI::App& program, int& result);
void addBench(CLI::App& program, int& result);
void addImport(CLI::App& program, int& result);
void addWorkbench(CLI::App& program, int& result);

}  // namespace merker::app
