// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>

#include "certain_hiding.hpp"
#include "check_summary.hpp"
#include "face_bins.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/image/image.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan::crosscheck {

struct SceneCheckOptions {
    bool flagged_only = false;  ///< ask about the pixels divided by exact areas only
    /// The unflagged pixels answer for their areas too (Extraction::Outline). Otherwise (Extraction::Paper)
    /// their errors are measured and are no disagreements.
    bool spans_are_exact = true;
    /// The scan divides pixels with Engine::Splitting. Another engine is asked about the divided pixels
    /// beside it, and answers for them; everything else is the scan's.
    Engine engine = Engine::Splitting;
    bool contacts =
        true;            ///< classify every contact of the paper's clipper too, wherever the oracle is asked
    bool kinds = false;  ///< what is met in each pixel is noted too (SceneCheck::kinds)
    std::uint64_t seed = 1;  ///< chooses the samples below
    /// One pixel in so many is put, with every face whose bounding box meets it, to rational splitting and to
    /// CGAL's Boolean set operations, whatever the cheaper rungs say.
    std::uint64_t rational_one_in = 64;
    std::uint64_t boolean_sets_one_in = 512;
};

/// What a pixel of the flag mask says.
enum class Flag : std::uint8_t { OneFace, ExactAreas, Scanline };

/// Checks a whole picture, as the scan hands it to the renderer, against the oracle.
///
/// For each pixel the oracle is asked about *all* projected faces whose bounding box meets it, found apart
/// from the scan (FaceBins), so that a face that the scan lost is missed here. Faces that are certainly
/// hidden are not asked about (CertainHiding), except in the samples.
///
/// Properties:
///   (1) The verdict, and every number but `seconds`, is the same for any number of threads.
///   (2) Every pixel of the picture is checked exactly once, or is a Disagreement of form.
/// Memory:  the projected faces, their bins, and seven bytes and a float for each pixel of the picture.
class SceneCheck {
  public:
    /// All references must outlive this.
    SceneCheck(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size,
               const SceneCheckOptions& options);

    /// Checks the rows of `band`, side by side. Bands come in order from the top.
    void take(const ScanBand& band);

    /// Everything found. Call when all bands have been taken: rows that never came are disagreements.
    const CheckSummary& finish();

    const CheckSummary& summary() const { return summary_; }
    const UnflaggedErrors& unflagged() const { return unflagged_; }
    /// The largest error of each pixel (areas, background); 0 where it was not asked about.
    const Image<float>& errors() const { return errors_; }
    const Image<Flag>& flags() const { return flags_; }
    /// Pixels with a disagreement.
    const Image<std::uint8_t>& wrong() const { return wrong_; }
    /// Faces that may be in each pixel, at most 65535 of them; their sum is CheckSummary::polygons.
    const Image<std::uint16_t>& faces() const { return face_counts_; }
    /// Of these, those that the oracle was asked about: they choose the bounds. 0 where certain hiding
    /// decided.
    const Image<std::uint16_t>& asked() const { return asked_counts_; }
    /// What was met where the contacts were checked (SceneCheckOptions::kinds).
    const Image<PixelKinds>& kinds() const { return kinds_; }

    /// What was asked of the oracle in a pixel: the faces that may be in it but for those that are certainly
    /// hidden, in rising order.
    std::vector<std::uint32_t> faces_asked(PixelIndex pixel) const;

  private:
    struct RowResult;
    class RowCheck;
    RowResult check_row(const ScanBand& band, int y);

    const ProjectedFaces& faces_;
    const Geometry& geometry_;
    ImageSize size_;
    SceneCheckOptions options_;
    FaceBins bins_;
    CertainHiding hiding_;
    int next_row_ = 0;
    CheckSummary summary_;
    UnflaggedErrors unflagged_;
    Image<float> errors_;
    Image<Flag> flags_;
    Image<std::uint8_t> wrong_;
    Image<std::uint16_t> face_counts_;
    Image<std::uint16_t> asked_counts_;
    Image<PixelKinds> kinds_;
};

}  // namespace keikan::crosscheck
