// SPDX-License-Identifier: GPL-3.0-or-later
#define GEOS_USE_ONLY_R_API
#include <geos_c.h>

#include <memory>
#include <stdexcept>

#include "peers/repeated_differences.hpp"

namespace keikan::peers {
namespace {

/// The C API, which is the one that its authors promise to keep. Differences go through OverlayNGRobust: in
/// floating point, and where that fails by snapping, and then by snap-rounding.
class Geos {
  public:
    using Region = std::shared_ptr<GEOSGeometry>;

    Geos() : context_(GEOS_init_r(), GEOS_finish_r) {
        GEOSContext_setErrorMessageHandler_r(
            context_.get(),
            [](const char* message, void* self) { static_cast<Geos*>(self)->message_ = message; }, this);
    }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    Region region(const Ring& ring) const {
        coordinates_.clear();
        for (const Point p : ring) coordinates_.insert(coordinates_.end(), {p.x, p.y});
        coordinates_.insert(coordinates_.end(), {ring.front().x, ring.front().y});
        GEOSCoordSequence* const sequence = GEOSCoordSeq_copyFromBuffer_r(
            context_.get(), coordinates_.data(), static_cast<unsigned>(ring.size() + 1), 0, 0);
        GEOSGeometry* const outline =
            sequence ? GEOSGeom_createLinearRing_r(context_.get(), sequence) : nullptr;
        return owned(outline ? GEOSGeom_createPolygon_r(context_.get(), outline, nullptr, 0) : nullptr);
    }
    bool is_empty(const Region& region) const { return GEOSisEmpty_r(context_.get(), region.get()) != 0; }
    Region difference(const Region& from, const Region& what) const {
        return owned(GEOSDifference_r(context_.get(), from.get(), what.get()));
    }
    double area(const Region& region) const {
        double area = 0;
        if (GEOSArea_r(context_.get(), region.get(), &area) == 0) throw std::runtime_error(message_);
        return area;
    }

  private:
    Region owned(GEOSGeometry* geometry) const {
        if (!geometry) throw std::runtime_error(message_);
        return {geometry, [context = context_.get()](GEOSGeometry* g) { GEOSGeom_destroy_r(context, g); }};
    }

    std::shared_ptr<GEOSContextHandle_HS> context_;
    std::string message_;
    mutable std::vector<double> coordinates_;
};

}  // namespace

Peer geos() {
    return {.name = "geos", .version = std::string("GEOS ") + GEOSversion(), .start = []() -> Ask {
                return [library = std::make_shared<Geos>()](const PreparedPixel& pixel, Answer& answer) {
                    ask_by_repeated_differences(*library, pixel, answer);
                };
            }};
}

}  // namespace keikan::peers
