// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

// The question, for every rung alike: the pixel's unit square; the faces' doubles, each exactly the number
// that it is; an outline is the convex hull of its points (which only matters where rounding has made it
// concave), and shows nothing if that has no area. ByDepth, w of two planes is compared exactly at every
// point; where it is equal everywhere, the smaller id is seen, and of two equal ids the earlier in the list.
//
// Requires: finite numbers, |pixel index| < 2^22.
namespace keikan::oracle {

/// Every area exactly, as a rational number. Parallel to the list of faces asked about; 0 where a face shows
/// nothing. areas + background = 1, exactly.
struct ExactAreas {
    std::vector<mpq_class> areas;
    mpq_class background;
    friend bool operator==(const ExactAreas&, const ExactAreas&) = default;
};

/// Proof, slowest rung: the visible region of each face by CGAL's Boolean set operations (Polygon_set_2 over
/// EPECK), its area summed exactly. Where CGAL's operations fail, as CGAL 5.5's sometimes do where parts
/// touch at a point, and where the product of some coordinates is no double, or do not add up to 1,
/// `areas_by_arrangement` answers. Cost: some 15 ms for a pixel of 7 faces.
ExactAreas areas_by_boolean_sets(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

/// Proof by a third method of CGAL's, which answers where the Boolean set operations give up: one arrangement
/// of all segments, each of whose faces is seen whole. Over fractions without a floating-point filter before
/// them, so that no coordinate is too large or too small. Cost: some 40 ms.
ExactAreas areas_by_arrangement(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

/// Proof by another method: convex splitting of point lists in rational arithmetic. Throws std::logic_error
/// if the areas do not add up to 1 exactly. Cost: some 0.1 ms for a pixel of 7 faces; where
/// numbers are denormal, and areas fractions of some ten thousand bits, 7 ms.
ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

/// The image point (x / w, y / w), w > 0.
struct RationalPoint {
    mpz_class x, y, w;
};

/// A face whose outline and depth plane w(x, y) = (a x + b y + c) / unit, unit > 0, are fractions, as no
/// double could state them.
struct RationalFace {
    FaceId id = 0;
    std::vector<RationalPoint> outline;
    mpz_class a, b, c, unit = 1;
};

/// The same of such faces, ByDepth.
ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const RationalFace* const> faces);

/// An area that is certainly within [value - error, value + error].
struct CertifiedArea {
    double value = 0;  ///< nearest double to the middle
    double error = 0;  ///< includes the rounding to `value`
};

struct CertifiedAreas {
    std::vector<CertifiedArea> areas;
    CertifiedArea background;
    bool certified = false;  ///< false: the rung could not decide, `areas` is empty
};

/// Proof, fast rung: combinatorics from exact signs of determinants of the input lines, areas in extended
/// precision with an error bound of some 1e-17, besides the rounding to a double. Not certified: numbers that
/// are not finite, or areas that do not add up to 1 within their errors, which would be a mistake of ours.
/// One object a thread. Cost: 10 to 60 microseconds for a pixel of 7 faces; hidden faces cost little.
class CertifiedSplitting {
  public:
    CertifiedSplitting();
    ~CertifiedSplitting();
    CertifiedSplitting(const CertifiedSplitting&) = delete;
    CertifiedSplitting& operator=(const CertifiedSplitting&) = delete;
    CertifiedAreas operator()(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

  private:
    struct Working;
    Working* working_;
};

}  // namespace keikan::oracle
