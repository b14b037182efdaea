// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace keikan::report {
namespace {

constexpr std::size_t kFailuresTold = 20;

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else if (code < 0x20 && c != '\n' && c != '\t')
            result += '?';
        else
            result += c;
    }
    return result;
}

std::string case_xml(const std::string& suite, const JunitCase& one) {
    const std::string head =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(suite), escaped(one.name));
    if (one.failure_count == 0) return head + "/>\n";
    std::string lines;
    for (const std::string& line : one.failures) lines += escaped(line) + "\n";
    if (one.failure_count > one.failures.size())
        lines += fmt::format("... and {} more\n", one.failure_count - one.failures.size());
    return fmt::format("{}>\n      <failure message=\"{} failures\">{}</failure>\n    </testcase>\n", head,
                       one.failure_count, lines);
}

}  // namespace

std::vector<JunitCase> junit_cases(const crosscheck::CheckSummary& summary) {
    using Kind = crosscheck::Disagreement::Kind;
    constexpr std::pair<Kind, const char*> kChecks[] = {
        {Kind::Area, "every area is within its bound of the exact one"},
        {Kind::Background, "every background is within its bound of the exact one"},
        {Kind::Sum, "areas and background add up to 1"},
        {Kind::Form, "every pixel is answered once, in due form"},
        {Kind::Attributes, "every face is shaded with its own plane, object and material"},
        {Kind::Given, "stated answers are the exact ones"},
        {Kind::Contact, "class, turn and indices of every contact are the exact ones"},
        {Kind::LeftOut, "nothing is seen of faces that were not asked about"},
        {Kind::Rungs, "the rungs of the oracle agree"},
    };
    std::vector<JunitCase> cases;
    for (const auto& [kind, name] : kChecks) {
        JunitCase one{name, {}, 0};
        for (const crosscheck::Disagreement& d : summary.disagreements) {
            if (d.kind != kind) continue;
            ++one.failure_count;
            if (one.failures.size() < kFailuresTold) one.failures.push_back(text_of(d));
        }
        cases.push_back(std::move(one));
    }
    if (summary.disagreement_count > summary.disagreements.size())
        cases.push_back({"no more disagreements than the summary lists",
                         {fmt::format("{} disagreements", summary.disagreement_count)},
                         1});
    return cases;
}

std::string junit_xml(const std::string& suite, std::span<const JunitCase> cases, double seconds) {
    const auto failed = std::ranges::count_if(cases, [](const JunitCase& c) { return c.failure_count > 0; });
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{:.3f}\">\n",
        escaped(suite), cases.size(), failed, seconds);
    for (const JunitCase& one : cases) text += case_xml(suite, one);
    return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace keikan::report
