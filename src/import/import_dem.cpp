// SPDX-License-Identifier: Apache-2.0
#include "import_dem.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "grey16_png_writer.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

constexpr double kWarpNoData = -1e30;  ///< in 32-bit float; no height is near it
constexpr int kVoidValue = 65535;
constexpr int kLargestValue = 65534;
constexpr double kMostSamples = 1 << 26;

struct Close {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

[[noreturn]] void fail(const DemImport& request, const std::string& reason) {
    std::string detail = CPLGetLastErrorMsg();
    std::replace(detail.begin(), detail.end(), '\n', ' ');
    throw InputError(request.source.string(), "", detail.empty() ? reason : reason + " (" + detail + ")");
}

/// Heights in metres, NaN where there is none, row by row from the north; the centre of the first sample.
struct Heights {
    int columns = 0;
    int rows = 0;
    double west_m = 0, north_m = 0;
    double spacing_x_m = 1, spacing_y_m = 1;
    bool whole_numbers = false;
    std::vector<double> metres;
};

bool is_north_up_metric(GDALDataset& source) {
    double g[6];
    const OGRSpatialReference* srs = source.GetSpatialRef();
    return source.GetGeoTransform(g) == CE_None && g[2] == 0 && g[4] == 0 && g[1] > 0 && g[5] < 0 &&
           srs != nullptr && srs->IsProjected() && srs->GetLinearUnits() == 1.0;
}

/// The UTM zone of the middle of the source.
std::string utm_zone_of(GDALDataset& source, const DemImport& request) {
    double g[6];
    const OGRSpatialReference* srs = source.GetSpatialRef();
    if (srs == nullptr || source.GetGeoTransform(g) != CE_None) fail(request, "has no place on the Earth");
    OGRSpatialReference geographic;
    geographic.SetWellKnownGeogCS("WGS84");
    geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference from(*srs);
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
        OGRCreateCoordinateTransformation(&from, &geographic));
    const double u = source.GetRasterXSize() / 2.0, v = source.GetRasterYSize() / 2.0;
    double x = g[0] + u * g[1] + v * g[2], y = g[3] + u * g[4] + v * g[5];
    if (!to_degrees || !to_degrees->Transform(1, &x, &y) || !(std::abs(y) <= 84)) {
        fail(request, "has no UTM zone; name a metric frame with --srs");
    }
    const int zone = std::clamp(static_cast<int>(std::floor((x + 180) / 6)) + 1, 1, 60);
    return fmt::format("EPSG:{}", (y >= 0 ? 32600 : 32700) + zone);
}

Dataset reprojected(GDALDataset& source, const DemImport& request) {
    std::vector<std::string> words{"-of", "MEM",   "-ot",        "Float32",
                                   "-r",  "cubic", "-dstnodata", fmt::format("{}", kWarpNoData)};
    const bool keeps_frame = !request.srs && is_north_up_metric(source);
    if (!keeps_frame) {
        words.insert(words.end(), {"-t_srs", request.srs ? *request.srs : utm_zone_of(source, request)});
    }
    if (request.spacing_m) {
        const std::string step = fmt::format("{}", *request.spacing_m);
        words.insert(words.end(), {"-tr", step, step});
    }
    if (request.window) {
        words.push_back("-te");
        for (const double side : *request.window) words.push_back(fmt::format("{}", side));
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::unique_ptr<GDALWarpAppOptions, void (*)(GDALWarpAppOptions*)> options(
        GDALWarpAppOptionsNew(arguments.data(), nullptr), &GDALWarpAppOptionsFree);
    if (!options) fail(request, "cannot be reprojected");
    GDALDatasetH sources[] = {GDALDataset::ToHandle(&source)};
    Dataset warped(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, sources, options.get(), nullptr)));
    if (!warped) fail(request, "cannot be reprojected");
    if (!is_north_up_metric(*warped)) fail(request, "the frame asked for is not one of metres");
    return warped;
}

double metres_per_unit(GDALRasterBand& band, const DemImport& request) {
    const std::string unit = band.GetUnitType();
    if (unit.empty() || unit == "m" || unit == "metre" || unit == "meter" || unit == "metres" ||
        unit == "meters") {
        return 1;
    }
    if (unit == "ft" || unit == "foot" || unit == "feet") return 0.3048;
    if (unit == "us-ft" || unit == "US survey foot" || unit == "sfoot") return 1200.0 / 3937;
    fail(request, fmt::format("its heights are in \"{}\", neither metres nor feet", unit));
}

Heights heights_of(GDALDataset& dataset, double metres_per_value, double offset_m, const DemImport& request) {
    double g[6];
    dataset.GetGeoTransform(g);
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    Heights heights;
    heights.columns = dataset.GetRasterXSize();
    heights.rows = dataset.GetRasterYSize();
    heights.spacing_x_m = g[1];
    heights.spacing_y_m = -g[5];
    heights.west_m = g[0] + g[1] / 2;  // GDAL counts from the outer corner of the first cell
    heights.north_m = g[3] + g[5] / 2;
    const GDALDataType type = band.GetRasterDataType();
    heights.whole_numbers =
        type != GDT_Float32 && type != GDT_Float64 && metres_per_value == 1 && offset_m == 0;
    if (static_cast<double>(heights.columns) * heights.rows > kMostSamples) {
        fail(request, fmt::format("{} x {} samples are too many; choose a --window or a wider --spacing",
                                  heights.columns, heights.rows));
    }
    heights.metres.resize(static_cast<std::size_t>(heights.columns) * static_cast<std::size_t>(heights.rows));
    if (band.RasterIO(GF_Read, 0, 0, heights.columns, heights.rows, heights.metres.data(), heights.columns,
                      heights.rows, GDT_Float64, 0, 0) != CE_None) {
        fail(request, "cannot be read");
    }
    int has_no_data = 0;
    const double no_data = band.GetNoDataValue(&has_no_data);
    for (double& height : heights.metres) {
        const bool is_void =
            !std::isfinite(height) || (has_no_data != 0 && height == no_data) || height <= -1e29;
        height = is_void ? std::numeric_limits<double>::quiet_NaN() : offset_m + metres_per_value * height;
    }
    return heights;
}

/// The finest step of 1, 2 or 5 times a power of ten, from a centimetre up, in which 16 bits hold `range_m`.
double step_for(double range_m) {
    double power = 0.01;
    for (;; power *= 10) {
        for (const double step : {power, 2 * power, 5 * power}) {
            if (range_m / step <= kLargestValue) return step;
        }
    }
}

struct Encoding {
    double offset_m = 0;
    double step_m = 1;
    std::uint16_t value(double height_m) const {
        if (std::isnan(height_m)) return kVoidValue;
        return static_cast<std::uint16_t>(
            std::clamp(std::lround((height_m - offset_m) / step_m), 0L, long{kLargestValue}));
    }
};

std::string frame_json(const Heights& heights, const Encoding& encoding, const ImportedDem& summary,
                       const DemImport& request) {
    nlohmann::ordered_json frame;
    frame["description"] = fmt::format(
        "{} x {} samples from {}, {}", heights.columns, heights.rows, request.source.filename().string(),
        summary.resampled ? "reprojected with cubic interpolation" : "copied sample by sample");
    frame["crs"] = summary.crs;
    frame["south_west_m"] = {heights.west_m, heights.north_m - (heights.rows - 1) * heights.spacing_y_m};
    frame["spacing_m"] = {heights.spacing_x_m, heights.spacing_y_m};
    frame["height_scale_m"] = encoding.step_m;
    frame["height_offset_m"] = encoding.offset_m;
    if (summary.voids > 0) frame["void_value"] = kVoidValue;
    return frame.dump(2) + "\n";
}

std::string name_of(const OGRSpatialReference& srs) {
    const char* authority = srs.GetAuthorityName(nullptr);
    const char* code = srs.GetAuthorityCode(nullptr);
    if (authority != nullptr && code != nullptr) return fmt::format("{}:{}", authority, code);
    const char* name = srs.GetName();
    return name != nullptr ? name : "unknown";
}

ImportedDem summary_of(const Heights& heights, GDALDataset& dataset, bool resampled,
                       const DemImport& request) {
    ImportedDem summary;
    summary.columns = heights.columns;
    summary.rows = heights.rows;
    summary.crs = name_of(*dataset.GetSpatialRef());
    summary.resampled = resampled;
    summary.lowest_m = std::numeric_limits<double>::infinity();
    summary.highest_m = -summary.lowest_m;
    for (const double height : heights.metres) {
        if (std::isnan(height)) {
            ++summary.voids;
            continue;
        }
        summary.lowest_m = std::min(summary.lowest_m, height);
        summary.highest_m = std::max(summary.highest_m, height);
    }
    if (summary.voids == heights.metres.size()) fail(request, "holds no height there");
    if (heights.columns < 2 || heights.rows < 2) fail(request, "has fewer than 2 x 2 samples");
    return summary;
}

void write_grid(const Heights& heights, const Encoding& encoding, const ImportedDem& summary,
                const DemImport& request) {
    std::vector<std::uint16_t> values(heights.metres.size());
    std::transform(heights.metres.begin(), heights.metres.end(), values.begin(),
                   [&](double height) { return encoding.value(height); });
    const std::string png = grey16_png(heights.columns, heights.rows, values);
    std::filesystem::path frame_file = request.grid;
    frame_file.replace_extension(".json");
    AtomicFile grid(request.grid), frame(frame_file);
    grid.write(png);
    frame.write(frame_json(heights, encoding, summary, request));
    frame.finish();
    grid.finish();
}

}  // namespace

ImportedDem import_dem(const DemImport& request) {
    if (request.grid.extension() != ".png") {
        throw InputError(request.grid.string(), "", "a height grid is written as .png");
    }
    GDALAllRegister();
    CPLSetErrorHandler(CPLQuietErrorHandler);  // GDAL's messages come with ours
    CPLErrorReset();
    const Dataset source(
        GDALDataset::Open(request.source.string().c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (!source) fail(request, "is no elevation model that GDAL reads");
    if (source->GetRasterCount() < 1) fail(request, "has no band");
    GDALRasterBand& band = *source->GetRasterBand(1);
    const double per_unit = metres_per_unit(band, request);
    const double scale = band.GetScale() * per_unit, offset = band.GetOffset() * per_unit;

    const bool resampled = request.srs || request.spacing_m || request.window || !is_north_up_metric(*source);
    const Dataset warped = resampled ? reprojected(*source, request) : nullptr;
    GDALDataset& metric = resampled ? *warped : *source;
    CPLErrorReset();
    const Heights heights = heights_of(metric, scale, offset, request);
    ImportedDem summary = summary_of(heights, metric, resampled, request);

    Encoding encoding{std::floor(summary.lowest_m), 1};
    const double range = summary.highest_m - encoding.offset_m;
    if (!heights.whole_numbers || range > kLargestValue) encoding.step_m = step_for(range);
    summary.height_step_m = encoding.step_m;
    write_grid(heights, encoding, summary, request);
    return summary;
}

}  // namespace keikan
