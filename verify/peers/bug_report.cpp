// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/bug_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/cases/wkt.hpp"
#include "oracle/exact_areas.hpp"

namespace keikan::peers {
namespace {

int rank(Outcome outcome) {
    switch (outcome) {
        case Outcome::Crash:
            return 4;
        case Outcome::Hang:
            return 3;
        case Outcome::Exception:
            return 2;
        case Outcome::Answered:
            return 1;
        case Outcome::NotAsked:
            return 0;
    }
    return 0;
}

const char* in_words(Outcome outcome) {
    switch (outcome) {
        case Outcome::Crash:
            return "crash";
        case Outcome::Hang:
            return "hang";
        case Outcome::Exception:
            return "no answer";
        case Outcome::Answered:
            return "wrong area";
        case Outcome::NotAsked:
            return "not asked";
    }
    return "";
}

std::string fraction(const mpq_class& number) {
    const std::string text = number.get_str();
    constexpr std::size_t kReadable = 60;
    return text.size() <= kReadable ? text : fmt::format("a fraction of {} digits", text.size() - 1);
}

std::string areas_table(const Finding& finding) {
    const PixelCase& asked = finding.pixel_case;
    const auto exact = oracle::areas_by_rational_splitting(asked.pixel, asked.faces(), asked.nearness());
    const bool answered = finding.reply.outcome == Outcome::Answered;
    std::string table = "| | answered | true | exactly |\n|---|---:|---:|---|\n";
    const auto row = [&](const std::string& name, double claimed, const mpq_class& truth) {
        table += fmt::format("| {} | {} | {:.17g} | {} |\n", name,
                             answered ? fmt::format("{:.17g}", claimed) : "", truth.get_d(), fraction(truth));
    };
    for (std::size_t i = 0; i < exact.areas.size(); ++i)
        row(fmt::format("polygon {}", i + 1), answered ? finding.reply.answer.areas[i] : 0, exact.areas[i]);
    row("none of them", finding.reply.answer.background, exact.background);
    return table;
}

}  // namespace

bool is_worse(const Reply& reply, double error, const Finding& than) {
    return std::pair(rank(reply.outcome), error) > std::pair(rank(than.reply.outcome), than.error);
}

Finding asked_about(PixelCase pixel_case, const Contestant& contestant, TruthTeller& truth) {
    std::vector<PixelCase> one{pixel_case};
    const Batch batch(std::move(one));
    Reply reply = contestant.ask(batch).replies.at(0);
    const double error = reply.outcome == Outcome::Answered ? error_of(reply.answer, truth(pixel_case)) : 0;
    return {std::move(pixel_case), std::move(reply), error};
}

bool shows_the_same(const Finding& smaller, const Finding& finding) {
    return smaller.reply.outcome == finding.reply.outcome && smaller.error >= finding.error / 2;
}

std::string bug_report(const Finding& finding, const Contestant& contestant, const std::string& replay) {
    const PixelCase& asked = finding.pixel_case;
    const Outcome outcome = finding.reply.outcome;
    std::string text = fmt::format("# {}: {}", contestant.version, in_words(outcome));
    text += outcome == Outcome::Answered ? fmt::format(" by {:.3g}\n\n", finding.error)
                                         : fmt::format(": {}\n\n", finding.reply.reason);
    text += fmt::format(
        "Asked for the area of each polygon that no {} covers, within the unit square at ({}, {}).\n\n",
        asked.depth ? "nearer polygon (the larger w = a x + b y + c at a point is nearer)"
                    : "earlier polygon of this list",
        contestant.is_library ? 0 : asked.pixel.x, contestant.is_library ? 0 : asked.pixel.y);
    for (std::size_t i = 0; i < asked.polygons.size(); ++i) {
        const Ring ring =
            contestant.is_library ? ring_in_pixel(asked.polygons[i], asked.pixel) : asked.polygons[i];
        text += fmt::format("{}. `{}`\n", i + 1, wkt_from_ring(ring));
        if (asked.depth) {
            const DepthPlane& w = (*asked.depth)[i];
            text += fmt::format("   w: {:.17g}, {:.17g}, {:.17g}\n", w.a, w.b, w.c);
        }
    }
    text += fmt::format("\n{}", areas_table(finding));
    if (contestant.is_library)
        text +=
            "\nThe polygons were cut to the square in exact arithmetic and rounded before they were handed "
            "over; the\n"
            "true areas are those of the pixel case, less than 1e-15 from those of the polygons above.\n";
    text += fmt::format("\nAs a pixel case:\n\n```json\n{}\n```\n\nTo see it again: `{}`\n",
                        pixel_case_line(asked), replay);
    return text;
}

}  // namespace keikan::peers
