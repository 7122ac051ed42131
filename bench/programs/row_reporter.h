#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace rayshoot {

/// Rows as we report them: medians with intervals, by our own names, without host name or program
/// path. Google Benchmark's own reporters print those, and 0 ns for a row that was skipped.
class RowReporter : public benchmark::BenchmarkReporter {
public:
    enum class Form { text, json };
    explicit RowReporter(Form form) : form_(form) {}

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;
    /// A row was skipped with an error: the program must not exit with 0.
    bool failed() const { return !errors_.empty(); }

private:
    struct Samples {
        std::vector<double> seconds;  ///< per iteration, one per repetition
        double rays = 0;              ///< per iteration; 0: not a row of rays
        double primitives = 0;        ///< built from, per iteration; 0: not a row of builds
        std::vector<double> peaks;    ///< bytes while building; of those that could be measured
    };
    void write_text();
    void write_json();

    Form form_;
    std::vector<std::string> order_;
    std::map<std::string, Samples> rows_;
    std::map<std::string, std::string> errors_;
};

}  // namespace rayshoot
