// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/standing.hpp"

#include <algorithm>
#include <cmath>

namespace keikan::peers {
namespace {

oracle::CertifiedArea rounded(const mpq_class& exact) {
    const double value = exact.get_d();
    // One unit in the last place is more than that rounding towards 0.
    return {value, std::abs(std::nextafter(value, HUGE_VAL) - value)};
}

double sum_error_of(const Answer& answer) {
    // long double: 64 bits, so that a few dozen additions round away less than 1e-17.
    long double sum = static_cast<long double>(answer.background) - 1;
    for (const double area : answer.areas) sum += area;
    return std::abs(static_cast<double>(sum));
}

}  // namespace

Truth TruthTeller::operator()(const PixelCase& pixel_case) {
    const std::vector<FaceView> faces = pixel_case.faces();
    oracle::CertifiedAreas quick = certify_(pixel_case.pixel, faces, pixel_case.nearness());
    if (quick.certified) return {std::move(quick.areas), quick.background, true};
    const oracle::ExactAreas exact =
        oracle::areas_by_rational_splitting(pixel_case.pixel, faces, pixel_case.nearness());
    Truth truth;
    for (const mpq_class& area : exact.areas) truth.areas.push_back(rounded(area));
    truth.background = rounded(exact.background);
    return truth;
}

double error_of(const Answer& answer, const Truth& truth) {
    const auto error = [](double answered, const oracle::CertifiedArea& exact) {
        return std::abs(answered - exact.value) + exact.error;
    };
    double largest = error(answer.background, truth.background);
    for (std::size_t i = 0; i < truth.areas.size(); ++i)
        largest = std::max(largest, error(answer.areas[i], truth.areas[i]));
    return largest;
}

void Tally::add(const Reply& reply, double error) {
    if (reply.outcome == Outcome::NotAsked) return;
    ++pixels;
    exceptions += reply.outcome == Outcome::Exception;
    crashes += reply.outcome == Outcome::Crash;
    hangs += reply.outcome == Outcome::Hang;
    if (reply.outcome != Outcome::Answered) return;
    for (std::size_t i = 0; i < kWrongBy.size(); ++i) wrong[i] += error > kWrongBy[i];
    largest_error = std::max(largest_error, error);
}

std::string family_named_in(const std::string& id) {
    const std::size_t slash = id.find('/');
    return slash == std::string::npos ? "" : id.substr(0, slash);
}

void add_round(Standing& standing, const Contestant& contestant, const Batch& batch,
               const std::vector<Truth>& truths, const Round& round) {
    standing.seconds += round.seconds;
    standing.timed_pixels += round.timed_pixels;
    for (std::size_t i = 0; i < round.replies.size(); ++i) {
        const Reply& reply = round.replies[i];
        const PixelCase& asked = batch.cases[i];
        const bool answered = reply.outcome == Outcome::Answered;
        const double error = answered ? error_of(reply.answer, truths[i]) : 0;
        if (answered && (standing.worst.empty() || error > standing.all.largest_error))
            standing.worst = asked.id;
        if (answered)
            standing.largest_sum_error = std::max(standing.largest_sum_error, sum_error_of(reply.answer));
        standing.all.add(reply, error);
        standing.by_family[family_named_in(asked.id)].add(reply, error);
        if (reply.outcome == Outcome::NotAsked) {
            ++standing.not_asked;
        } else if (contestant.promised_error) {
            const bool kept = answered && error <= contestant.promised_error(asked.polygons.size());
            standing.broken_promises += !kept;
        }
    }
}

}  // namespace keikan::peers
