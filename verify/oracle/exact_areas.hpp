// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CGAL/Gmpq.h>

#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan::oracle {

/// Every area exactly, as a rational number. Parallel to the list of faces asked about; 0 where a face shows
/// nothing. areas + background = 1, exactly.
struct ExactAreas {
    std::vector<CGAL::Gmpq> areas;
    CGAL::Gmpq background;
    friend bool operator==(const ExactAreas&, const ExactAreas&) = default;
};

/// Proof, slowest rung: the visible region of each face by CGAL's Boolean set operations (Polygon_set_2 over
/// EPECK), its area summed exactly.
ExactAreas areas_by_boolean_sets(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

/// Proof by a third method of CGAL's, which answers where the Boolean set operations give up: one arrangement of all
/// segments, each of whose faces is seen whole.
ExactAreas areas_by_arrangement(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

/// Proof by another method: convex splitting of point lists in rational arithmetic.
ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

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
/// precision with a running error bound. One object a thread.
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
