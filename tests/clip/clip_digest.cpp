// SPDX-License-Identifier: Apache-2.0
//
// What the clip room answers, so that builds of it by other compilers and with other flags can be compared
// (scripts/matrix). Questions and the reference's answers are a file, so that all builds are asked the same
// doubles.
//
//   clip_digest record FILE   degenerate pixels, their exact areas, and every clip step of the traversal
//   clip_digest replay FILE   asks all of them again, prints one line of what came out and how far it differs
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "degenerate_pixels.hpp"
#include "double_double.hpp"
#include "exact_areas.hpp"
#include "expansion.hpp"
#include "keikan/clip/classify_intersections.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace {

using namespace keikan;
using namespace keikan::test;

constexpr int kPixels = 120;     // of each family, half of them with depth planes
constexpr int kExactPixels = 6;  // the first of them have exact areas too

/// FNV-1a.
class Digest {
  public:
    template <class T>
    void add(const T& value) {
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001B3u;
    }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xCBF29CE484222325u;
};

struct Step {
    Ring subject, clip;
    std::vector<Contact> contacts;
};

struct Question {
    PixelCase pixel_case;
    std::vector<double> areas;     ///< the reference's, by the splitting; the background at the end
    std::vector<ExactArea> exact;  ///< empty: not asked
    std::vector<Step> steps;       ///< of the reference's traversal
};

// --- the file ----------------------------------------------------------------------------------------------

template <class T>
void put(std::ostream& out, const T& value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(T));
}
template <class T>
void put(std::ostream& out, const std::vector<T>& values) {
    put(out, static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) put(out, value);
}
void put(std::ostream& out, const Step& step) {
    put(out, step.subject), put(out, step.clip), put(out, step.contacts);
}

template <class T>
void take(std::istream& in, T& value) {
    in.read(reinterpret_cast<char*>(&value), sizeof(T));
}
template <class T>
void take(std::istream& in, std::vector<T>& values) {
    std::uint32_t size = 0;
    take(in, size);
    values.resize(in ? size : 0);
    for (T& value : values) take(in, value);
}
void take(std::istream& in, Step& step) {
    take(in, step.subject), take(in, step.clip), take(in, step.contacts);
}

void put(std::ostream& out, const Question& q) {
    put(out, q.pixel_case.pixel), put(out, q.pixel_case.polygons);
    put(out, q.pixel_case.depth.value_or(std::vector<DepthPlane>{}));
    put(out, q.areas), put(out, q.exact), put(out, q.steps);
}

bool take(std::istream& in, Question& q) {
    take(in, q.pixel_case.pixel), take(in, q.pixel_case.polygons);
    std::vector<DepthPlane> depth;
    take(in, depth);
    if (!depth.empty()) q.pixel_case.depth = depth;
    take(in, q.areas), take(in, q.exact), take(in, q.steps);
    return static_cast<bool>(in);
}

// --- questions and answers ---------------------------------------------------------------------------------

/// Parallel to the faces, the background at the end.
std::vector<double> areas_of(VisibleAreas& engine, const PixelCase& pixel_case) {
    const std::vector<FaceView> faces = pixel_case.faces();
    const PixelCoverage seen = engine(pixel_case.pixel, faces, pixel_case.nearness());
    std::vector<double> areas(faces.size() + 1);
    for (const VisiblePart& part : seen.parts) areas[part.face] = part.area;
    areas.back() = seen.background;
    return areas;
}

void record(std::ostream& out) {
    VisibleAreas splitting, traversal(Engine::Traversal);
    std::vector<Step>* steps = nullptr;
    traversal.observe([&](const ClipStep& step) {
        steps->push_back({{step.subject.begin(), step.subject.end()},
                          {step.clip.begin(), step.clip.end()},
                          {step.contacts.begin(), step.contacts.end()}});
    });
    for (const Family& family : families()) {
        Dice dice(1);
        for (int i = 0; i < kPixels; ++i) {
            Question question;
            question.pixel_case = random_pixel(family, dice, i % 2 == 1);
            question.areas = areas_of(splitting, question.pixel_case);
            if (i < kExactPixels && family.name != "crowd") question.exact = exact_areas(question.pixel_case);
            steps = &question.steps;
            areas_of(traversal, question.pixel_case);
            put(out, question);
        }
    }
}

struct Replay {
    std::uint64_t pixels = 0, steps = 0, contacts = 0, misclassified = 0;
    double deviation = 0;  ///< from the reference's areas, of pixels of up to 8 faces
    double error = 0;      ///< from exact areas
    double sum_error = 0;
    Digest classes, splitting_bits, traversal_bits;
    VisibleAreas splitting, traversal{Engine::Traversal};
    IntersectionClassifier classify{IntersectionClassifier::Lattice::Pixel};

    void ask(const Step& step) {
        const auto found = classify(step.subject, step.clip);
        bool same = found.size() == step.contacts.size();
        for (std::size_t i = 0; i < found.size(); ++i) {
            classes.add(found[i].kind), classes.add(found[i].turn);
            classes.add(found[i].subject), classes.add(found[i].clip);
            const Contact& r = step.contacts[same ? i : 0];
            same = same && found[i].kind == r.kind && found[i].turn == r.turn &&
                   found[i].subject == r.subject && found[i].clip == r.clip;
        }
        ++steps, contacts += found.size(), misclassified += !same;
    }

    void ask(const Question& question, VisibleAreas& engine, Digest& bits) {
        const std::vector<double> areas = areas_of(engine, question.pixel_case);
        double sum = -1;
        for (std::size_t i = 0; i < areas.size(); ++i) {
            bits.add(areas[i]);
            sum += areas[i];
            if (areas.size() <= 9) deviation = std::max(deviation, std::abs(areas[i] - question.areas[i]));
            if (!question.exact.empty())
                error =
                    std::max(error, std::abs((areas[i] - question.exact[i].high) - question.exact[i].low));
        }
        sum_error = std::max(sum_error, std::abs(sum));
    }

    void ask(const Question& question) {
        ++pixels;
        ask(question, splitting, splitting_bits);
        ask(question, traversal, traversal_bits);
        for (const Step& step : question.steps) ask(step);
    }
};

/// The arithmetic below everything: exact in every build, so that the digest is the same whatever is fused;
/// and the error of quotients, in halves of an ulp.
struct Arithmetic {
    Digest exact;
    double quotient_error = 0;

    Arithmetic() {
        Dice dice(2);
        const auto number = [&] {
            const double mantissa = dice.between(-1, 1);
            return std::ldexp(mantissa, dice.number(-30, 30));
        };
        for (int i = 0; i < 100'000; ++i) {
            const double a = number(), b = number(), c = number();
            const clip::DoubleDouble product = clip::two_product(a, b), sum = clip::two_sum(a * b, c);
            exact.add(product), exact.add(sum);
            clip::Expansion<8> expansion;
            for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {-a, std::nextafter(b, 2)}, {-b, c}})
                expansion.add(clip::two_product(p, q));
            exact.add(expansion.largest());
            const clip::DoubleDouble x{a, a * 0x1p-54}, y{b, b * -0x1p-55};
            const double q = clip::quotient(x, y);
            const clip::DoubleDouble rest = x - clip::DoubleDouble{q, 0} * y;
            const double half_ulp = 0x1p-53 * std::ldexp(1, std::ilogb(q));
            quotient_error = std::max(quotient_error, std::abs(rest.hi / b) / half_ulp);
        }
    }
};

int replay(std::istream& in) {
    const Arithmetic arithmetic;
    Replay all;
    for (Question question; take(in, question); question = {}) all.ask(question);
    std::printf(
        "{\"pixels\": %llu, \"steps\": %llu, \"contacts\": %llu, \"steps_misclassified\": %llu, "
        "\"classes\": \"%016llx\", \"splitting\": \"%016llx\", \"traversal\": \"%016llx\", "
        "\"deviation\": %.3g, \"error\": %.3g, \"sum_error\": %.3g, "
        "\"arithmetic\": \"%016llx\", \"quotient_error\": %.9f}\n",
        static_cast<unsigned long long>(all.pixels), static_cast<unsigned long long>(all.steps),
        static_cast<unsigned long long>(all.contacts), static_cast<unsigned long long>(all.misclassified),
        static_cast<unsigned long long>(all.classes.value()),
        static_cast<unsigned long long>(all.splitting_bits.value()),
        static_cast<unsigned long long>(all.traversal_bits.value()), all.deviation, all.error, all.sum_error,
        static_cast<unsigned long long>(arithmetic.exact.value()), arithmetic.quotient_error);
    return all.pixels == 0 ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc == 3 ? argv[1] : "";
    if (what == "record") {
        std::ofstream out(argv[2], std::ios::binary);
        record(out);
        return out.flush() ? 0 : 2;
    }
    if (what == "replay") {
        std::ifstream in(argv[2], std::ios::binary);
        return replay(in);
    }
    std::cerr << "clip_digest record|replay FILE\n";
    return 2;
}
