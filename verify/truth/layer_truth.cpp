// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_truth.hpp"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "rounding.hpp"

namespace keikan::truth {
namespace {

/// A point in pixels.
struct ExactPoint {
    mpq_class x, y;
    friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};

/// From the plane to pixels, without rounding.
class ToPixels {
  public:
    ToPixels(const Window& window, ImageSize size)
        : from_{mpq_class(window.from.x), mpq_class(window.from.y)},
          scale_{size.width / (mpq_class(window.to.x) - from_.x),
                 size.height / (mpq_class(window.to.y) - from_.y)} {}

    ExactPoint operator()(Point p) const {
        return {(mpq_class(p.x) - from_.x) * scale_.x, (mpq_class(p.y) - from_.y) * scale_.y};
    }

  private:
    ExactPoint from_;
    ExactPoint scale_;
};

// ---------------------------------------------------------------- what is visible

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// A segment of the arrangement knows which given segments run along it.
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, std::uint32_t>;
/// A face has a position in a list of labels, or -1.
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, std::int32_t>>;

/// A piece of the border between two visible regions; `left` is seen to the left of from -> to (x to the
/// right, y upwards).
struct BorderPiece {
    ExactPoint from, to;
    std::uint32_t left = Share::kBackground;
    std::uint32_t right = Share::kBackground;
};

class Overlay {
  public:
    Overlay(std::span<const Layer> layers, const ToPixels& to_pixels) {
        for (std::uint32_t layer = 0; layer < layers.size(); ++layer)
            for (const Polygon& polygon : layers[layer].polygons) {
                add_ring(polygon.outline, to_pixels);
                for (const Ring& hole : polygon.holes) add_ring(hole, to_pixels);
                layer_of_polygon_.push_back(layer);
            }
        CGAL::insert(arrangement_, curves_.begin(), curves_.end());
        label_faces();
    }

    std::vector<BorderPiece> borders() const {
        std::vector<BorderPiece> pieces;
        for (auto edge = arrangement_.edges_begin(); edge != arrangement_.edges_end(); ++edge) {
            const std::uint32_t left = owner(edge->face()), right = owner(edge->twin()->face());
            if (left == right) continue;
            pieces.push_back({exact(edge->source()->point()), exact(edge->target()->point()), left, right});
        }
        return pieces;
    }

  private:
    /// The polygons that a face of the arrangement lies in, by rising position.
    using Label = std::vector<std::uint32_t>;

    void add_ring(const Ring& ring, const ToPixels& to_pixels) {
        std::vector<ExactPoint> points;
        for (const Point p : ring) points.push_back(to_pixels(p));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ExactPoint &p = points[i], &q = points[i + 1 == points.size() ? 0 : i + 1];
            if (p == q) continue;
            const CGAL::Arr_segment_traits_2<Kernel>::Curve_2 segment(
                Kernel::Point_2(Kernel::FT(p.x), Kernel::FT(p.y)),
                Kernel::Point_2(Kernel::FT(q.x), Kernel::FT(q.y)));
            curves_.emplace_back(segment, static_cast<std::uint32_t>(polygon_of_segment_.size()));
            polygon_of_segment_.push_back(static_cast<std::uint32_t>(layer_of_polygon_.size()));
        }
    }

    /// From the unbounded face on: to cross a segment is to enter or leave the polygons whose rings run along
    /// it an odd number of times.
    void label_faces() {
        std::vector<Arrangement::Face_handle> reached;
        for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end(); ++face)
            face->set_data(-1);
        const auto reach = [&](Arrangement::Face_handle face, Label label) {
            face->set_data(static_cast<std::int32_t>(labels_.size()));
            labels_.push_back(std::move(label));
            reached.push_back(face);
        };
        for (auto face = arrangement_.unbounded_faces_begin(); face != arrangement_.unbounded_faces_end();
             ++face)
            reach(face, {});
        while (!reached.empty()) {
            const Arrangement::Face_handle face = reached.back();
            reached.pop_back();
            const auto look_across = [&](Arrangement::Ccb_halfedge_circulator around) {
                const Arrangement::Ccb_halfedge_circulator first = around;
                do {
                    const Arrangement::Face_handle other = around->twin()->face();
                    if (other->data() < 0) reach(other, label_across(face, around->curve().data()));
                } while (++around != first);
            };
            for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) look_across(*ccb);
            for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) look_across(*ccb);
        }
    }

    template <typename Segments>
    Label label_across(Arrangement::Face_handle face, const Segments& segments) const {
        Label label = labels_[static_cast<std::size_t>(face->data())];
        for (auto segment = segments.begin(); segment != segments.end(); ++segment) {
            const std::uint32_t polygon = polygon_of_segment_[*segment];
            const auto at = std::ranges::lower_bound(label, polygon);
            if (at != label.end() && *at == polygon)
                label.erase(at);
            else
                label.insert(at, polygon);
        }
        return label;
    }

    /// Polygons stand in the order of their layers, so the first is of the nearest.
    std::uint32_t owner(Arrangement::Face_const_handle face) const {
        const Label& label = labels_[static_cast<std::size_t>(face->data())];
        return label.empty() ? Share::kBackground : layer_of_polygon_[label.front()];
    }

    static ExactPoint exact(const Kernel::Point_2& p) {
        return {mpq_class(CGAL::exact(p.x()).get_mpq_t()), mpq_class(CGAL::exact(p.y()).get_mpq_t())};
    }

    std::vector<Traits::Curve_2> curves_;
    std::vector<std::uint32_t> polygon_of_segment_;
    std::vector<std::uint32_t> layer_of_polygon_;
    Arrangement arrangement_;
    std::vector<Label> labels_;
};

// ---------------------------------------------------------------- through the pixels

/// What a piece of border adds in one row. The area of a region in a pixel is the integral of clamp(x -
/// column, 0, 1) dy along its border: a piece in the column adds `in_column` there, and its height to every
/// column before it.
struct Event {
    std::uint32_t layer = 0;
    std::int32_t column = 0;  ///< the width of the picture: to the right of it
    mpq_class in_column;
    mpq_class height;
};

mpz_class floor_of(const mpq_class& value) {
    mpz_class result;
    mpz_fdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return result;
}

mpz_class ceiling_of(const mpq_class& value) {
    mpz_class result;
    mpz_cdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return result;
}

/// A whole number, brought into [0, most].
int clamped(const mpz_class& value, int most) {
    if (value < 0) return 0;
    if (value > most) return most;
    return static_cast<int>(value.get_si());
}

/// Cuts pieces of border at the lines between pixels and hands the parts to their rows.
class RowEvents {
  public:
    explicit RowEvents(ImageSize size) : size_(size), rows_(static_cast<std::size_t>(size.height)) {}

    void add(const BorderPiece& piece) {
        const bool rises = piece.from.y < piece.to.y;
        if (piece.from.y == piece.to.y) return;  // no height: it adds nothing
        const ExactPoint &low = rises ? piece.from : piece.to, &high = rises ? piece.to : piece.from;
        const mpq_class run = (high.x - low.x) / (high.y - low.y);
        const int first = clamped(floor_of(low.y), size_.height),
                  end = clamped(ceiling_of(high.y), size_.height);
        for (int row = first; row < end; ++row) {
            const mpq_class y0 = std::max(low.y, mpq_class(row)), y1 = std::min(high.y, mpq_class(row + 1));
            if (y0 >= y1) continue;
            add_in_row(piece, row, rises, {low.x + run * (y0 - low.y), y0}, {low.x + run * (y1 - low.y), y1});
        }
    }

    std::vector<Event>& row(int y) { return rows_[static_cast<std::size_t>(y)]; }

  private:
    void add_in_row(const BorderPiece& piece, int row, bool rises, const ExactPoint& from,
                    const ExactPoint& to) {
        const bool rightwards = from.x <= to.x;
        const ExactPoint &left = rightwards ? from : to, &right = rightwards ? to : from;
        const mpq_class height = to.y - from.y;
        if (left.x == right.x) {
            // A border along the line between two columns belongs to the one after it: there x - column is 0.
            add_part(piece, row, rises, left.x < 0 ? -1 : clamped(floor_of(left.x), size_.width), left.x,
                     height);
            return;
        }
        const mpq_class rise = height / (right.x - left.x);
        const auto part = [&](const mpq_class& x0, const mpq_class& x1, int column) {
            if (x0 < x1) add_part(piece, row, rises, column, (x0 + x1) / 2, (x1 - x0) * rise);
        };
        // What lies left of the picture adds nothing to it; what lies right of it, its height to every
        // column.
        part(std::max(left.x, mpq_class(size_.width)), right.x, size_.width);
        const int first = clamped(floor_of(left.x), size_.width),
                  end = clamped(ceiling_of(right.x), size_.width);
        for (int column = first; column < end; ++column)
            part(std::max(left.x, mpq_class(column)), std::min(right.x, mpq_class(column + 1)), column);
    }

    void add_part(const BorderPiece& piece, int row, bool rises, int column, const mpq_class& middle,
                  const mpq_class& height) {
        if (column < 0) return;
        const mpq_class up = rises ? height : mpq_class(-height);
        const mpq_class in_column = column < size_.width ? mpq_class(up * (middle - column)) : mpq_class(0);
        std::vector<Event>& events = rows_[static_cast<std::size_t>(row)];
        // With the region to the left of the way, the integral of x dy around it is its area.
        if (piece.left != Share::kBackground) events.push_back({piece.left, column, in_column, up});
        if (piece.right != Share::kBackground) events.push_back({piece.right, column, -in_column, -up});
    }

    ImageSize size_;
    std::vector<std::vector<Event>> rows_;
};

/// An exact coverage of a pixel.
struct ExactShare {
    std::int32_t column = 0;
    std::uint32_t layer = 0;
    mpq_class coverage;
};

/// The coverages of a row that are not 0, by rising column and layer, the background last.
std::vector<ExactShare> row_shares(std::vector<Event>& events, int width) {
    std::ranges::stable_sort(events, [](const Event& p, const Event& q) {
        return std::pair(p.layer, -p.column) < std::pair(q.layer, -q.column);
    });
    std::vector<ExactShare> shares;
    for (std::size_t i = 0; i < events.size();) {
        const std::uint32_t layer = events[i].layer;
        mpq_class after = 0;  // heights of what lies in later columns
        for (int column = width; column >= 0; --column) {
            mpq_class here = after;
            for (; i < events.size() && events[i].layer == layer && events[i].column == column; ++i) {
                here += events[i].in_column;
                after += events[i].height;
            }
            if (column < width && here != 0) shares.push_back({column, layer, here});
            if (after == 0 && (i == events.size() || events[i].layer != layer)) break;
        }
    }
    std::ranges::sort(shares, [](const ExactShare& p, const ExactShare& q) {
        return std::pair(p.column, p.layer) < std::pair(q.column, q.layer);
    });
    std::vector<ExactShare> all;
    std::size_t i = 0;
    for (int column = 0; column < width; ++column) {
        mpq_class background = 1;
        for (; i < shares.size() && shares[i].column == column; ++i) {
            background -= shares[i].coverage;
            KEIKAN_CHECK(shares[i].coverage > 0, "a layer covers less than nothing of a pixel");
            all.push_back(std::move(shares[i]));
        }
        KEIKAN_CHECK(background >= 0, "the layers cover more than all of a pixel");
        if (background != 0) all.push_back({column, Share::kBackground, background});
    }
    return all;
}

/// Errors: InputError where CGAL's intervals overflow (oracle/boolean_sets.cpp says how), which no map does.
std::vector<BorderPiece> borders_of(std::span<const Layer> layers, const ToPixels& to_pixels) {
    try {
        return Overlay(layers, to_pixels).borders();
    } catch (const CGAL::Failure_exception&) {
        throw InputError(
            "layers: undecided: coordinates so many powers of two apart that CGAL's intervals "
            "overflow");
    }
}

}  // namespace

CoveragePicture layer_coverage(
    std::span<const Layer> layers, const Window& window, ImageSize size,
    const std::function<void(PixelIndex, std::uint32_t layer, const mpq_class&)>& exact) {
    KEIKAN_CHECK(window.from.x != window.to.x && window.from.y != window.to.y, "a window without area");
    CoveragePicture picture{size, {}, {}, {}};
    for (const Layer& layer : layers) picture.mattes.push_back(layer.name);
    RowEvents events(size);
    for (const BorderPiece& piece : borders_of(layers, ToPixels(window, size))) events.add(piece);

    const auto rows = static_cast<std::size_t>(size.height);
    const auto slots = 4 * static_cast<std::size_t>(thread_count());
    std::vector<std::vector<ExactShare>> made(slots);
    const auto make = [&](std::size_t y, std::size_t slot) {
        made[slot] = row_shares(events.row(static_cast<int>(y)), size.width);
    };
    std::vector<Share> seen;
    const auto take = [&](std::size_t y, std::size_t slot) {
        std::size_t i = 0;
        for (int x = 0; x < size.width; ++x) {
            seen.clear();
            for (; i < made[slot].size() && made[slot][i].column == x; ++i) {
                const ExactShare& share = made[slot][i];
                if (exact) exact({x, static_cast<int>(y)}, share.layer, share.coverage);
                const float coverage = nearest_float(share.coverage);
                if (coverage > 0) seen.push_back({share.layer, coverage, nearest_code(share.coverage)});
            }
            picture.add_pixel(seen);
        }
        events.row(static_cast<int>(y)) = {};
    };
    parallel_in_order(rows, slots, make, take);
    return picture;
}

}  // namespace keikan::truth
